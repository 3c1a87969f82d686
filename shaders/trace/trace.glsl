// SPDX-License-Identifier: MIT
// The one question that every ray asks: what is there? Meshes and fields stand in one two-level
// tree; a leaf of the upper level is a mesh with a tree of its own, or the box of a field.
// Defines: TRACE_ANY (1: is there anything at all), HAS_MESHES, HAS_FIELDS, HAS_CULLING (triangles
// that are not seen from behind), HAS_FILTERS (surfaces that let rays pass, see trace/filter.glsl),
// HAS_CONES (rays that mind what they pass, see trace/cone.glsl).
//
// The loops have the shape that pays on CPUs that run 8 pixels in lockstep and skip nothing:
// - one inner loop walks both levels. Its step reads three texels that are a node or a triangle
//   and does both tests, because a branch not taken costs as much as one taken;
// - what happens once an instance (its transform, the march of a field), or where a surface may let
//   the ray pass, stands outside of it.
#include "trace/node.glsl"
#include "trace/triangle.glsl"
#include "trace/filter.glsl"
#include "lib/hit_record.glsl"
#if HAS_FIELDS
#include "trace/march.glsl"
#endif

const uint kNowhere = 0xffffffffu;

// TRACE_ANY: the share of light that arrives along a ray for which trace() found no obstacle. 1 where
// nothing filters.
vec3 transmittance = vec3(1.0);
// TRACE_ANY: does light go straight through glass? False for light that is also found by the rays
// that are refracted, and would be counted twice.
bool lightPassesGlass = true;
const float kLeastTransmittance = 0.004;

#if HAS_FILTERS && TRACE_ANY
// Takes from the light what a surface holds back. True if next to nothing is left.
// `passed`: the triangles met last. `depth` and `inside`: see trace().
bool weaken(Barrier barrier, uvec4 record, inout uvec4 passed, inout vec3 depth, inout vec3 inside) {
    uint triangle = (record.x << 24u) ^ record.y;
    bool again = any(equal(passed, uvec4(triangle))) &&
                 fetchInstance(int(record.x)).kind == VITRINE_KIND_MESH;
    if (again) return false;
    passed = uvec4(triangle, passed.xyz);
    vec3 glass = lightPassesGlass ? barrier.glass : vec3(0.0);
    transmittance *= 1.0 - barrier.opacity + barrier.opacity * glass;
    if (glass != vec3(0.0)) {
        float sign = barrier.back ? 1.0 : -1.0;
        depth += sign * recordDistance(record) * barrier.absorption;
        inside -= sign * barrier.absorption;
    }
    return maxComponent(transmittance) < kLeastTransmittance;
}
#endif

// The record of the closest surface nearer than tMax, or of a miss. With TRACE_ANY: of any surface.
uvec4 trace(Ray ray, float tMax) {
    COUNT(countedRays);
    uint stack[VITRINE_STACK_SIZE];
    int depth = 0;
    int floorDepth = 0;  // entries below belong to the upper level
    bool insideMesh = false;
    int instanceIndex = 0;
    vec3 origin = ray.origin;  // of the ray in the space of the tree that is walked
    vec3 direction = ray.direction;
    vec3 inverse = safeInverse(direction);
#if HAS_MESHES
    RayShear shear = rayShear(direction);
#endif
    uvec4 best = missRecord();
    float tBest = tMax;
#if HAS_CULLING
    bool culled = false;
#endif
#if HAS_FILTERS
    bool filtered = false;  // does this instance let rays pass?
    bool pending = false;   // a hit that is to be looked at
    uvec4 candidate = missRecord();
    float fieldStart = 0.0;       // of a field that let the ray pass here
    uint fieldLeaf = kNowhere;
#if TRACE_ANY
    transmittance = vec3(1.0);
    vec3 depth3 = vec3(0.0);  // optical, of what the ray has left, less where it has entered
    vec3 inside = vec3(0.0);  // absorption of what it has entered and not left
    uvec4 passed = uvec4(0xffffffffu);  // a triangle may stand in the tree twice
#endif
#endif
#if HAS_CONES
    openCone(tMax);
#endif
    uint current = uint(frame.counts.z);
    if (frame.counts.z < 0 || tMax <= 0.0) current = kNowhere;

    while (mayLoop()) {
        // Walk until an instance is met or the tree is exhausted.
        while (mayLoop()) {
            bool leaf = (current & VITRINE_LEAF_BIT) != 0u;
            if (current == kNowhere || (leaf && !insideMesh)) break;
            COUNT(countedNodes);
            Slot slot = fetchSlot(int(current & ~VITRINE_LEAF_BIT));
            bool pop;
            if (!leaf) {
                #if HAS_CONES
                float spread = insideMesh ? 0.0 : coneSpread();
#else
                const float spread = 0.0;
#endif
                uvec4 keys = intersectChildren(slot, origin, inverse, tBest, spread);
                if (keys.w != kNoChild) stack[depth++] = childOf(slot, keys.w);
                if (keys.z != kNoChild) stack[depth++] = childOf(slot, keys.z);
                if (keys.y != kNoChild) stack[depth++] = childOf(slot, keys.y);
                pop = keys.x == kNoChild;
                current = childOf(slot, keys.x);
            } else {
#if HAS_MESHES
                float t;
                vec2 barycentrics;
                bool seen = true;
#if HAS_CULLING && !TRACE_ANY
                vec3 corner = uintBitsToFloat(slot.a.xyz);
                seen = !culled || dot(cross(uintBitsToFloat(slot.b.xyz) - corner,
                                            uintBitsToFloat(slot.c.xyz) - corner),
                                      direction) < 0.0;
#endif
                if (seen && intersectTriangle(origin, shear, uintBitsToFloat(slot.a.xyz),
                                      uintBitsToFloat(slot.b.xyz), uintBitsToFloat(slot.c.xyz),
                                      tBest, t, barycentrics)) {
                    uvec4 found = packHit(uint(instanceIndex), slot.a.w & ~VITRINE_LAST_TRIANGLE_BIT,
                                          packBarycentrics(barycentrics), t);
#if HAS_FILTERS
                    pending = filtered;
                    candidate = found;
                    if (!filtered)
#endif
                    {
                        tBest = t;
                        best = found;
                    }
                }
#endif
                pop = (slot.a.w & VITRINE_LAST_TRIANGLE_BIT) != 0u;
                current++;
            }
            if (pop) {
                current = kNowhere;
                if (depth > floorDepth) {
                    depth--;
                    current = stack[depth];
                }
            }
#if TRACE_ANY
            if (isSurface(best)) current = kNowhere;
#endif
#if HAS_FILTERS
            if (pending) break;
#endif
        }
#if TRACE_ANY
        if (isSurface(best)) break;
#endif
#if HAS_FILTERS
        bool atInstance = !pending;
#else
        const bool atInstance = true;
#endif
        if (atInstance && current == kNowhere) {
            if (!insideMesh) break;
            // Back to the upper level.
            insideMesh = false;
            floorDepth = 0;
            origin = ray.origin;
            direction = ray.direction;
            inverse = safeInverse(direction);
            if (depth > 0) {
                depth--;
                current = stack[depth];
            }
        }
        if (current == kNowhere && atInstance) break;
        if (atInstance && (current & VITRINE_LEAF_BIT) != 0u) {
            // A leaf of the upper level names its instance in its slot.
            instanceIndex = int(fetchSlot(int(current & ~VITRINE_LEAF_BIT)).a.x);
            Instance instance = fetchInstance(instanceIndex);
            vec3 objectOrigin = transformPoint(instance.objectFromWorld, ray.origin);
            vec3 objectDirection = transformVector(instance.objectFromWorld, ray.direction);
            float start = 0.0;
#if HAS_FILTERS
            filtered = (instance.flags & VITRINE_INSTANCE_FILTERED) != 0;
            start = fieldStart;
            fieldStart = 0.0;
            fieldLeaf = current;
#endif
            current = kNowhere;
#if HAS_FIELDS
            FieldHit field = marchField(instance, instanceIndex, instance.kind == VITRINE_KIND_FIELD, objectOrigin,
                                        objectDirection, ray.radius, start, tBest);
            if (field.hit) {
                uvec4 found = fieldRecord(instanceIndex, instance, field);
#if HAS_FILTERS
                pending = filtered;
                candidate = found;
                if (!filtered)
#endif
                {
                    tBest = field.t;
                    best = found;
                }
            }
#endif
#if HAS_MESHES
            bool entered = instance.kind == VITRINE_KIND_MESH;
#if HAS_CONES
            entered = entered && coneAsks != kAskTaps;
#endif
            if (entered) {
                insideMesh = true;
                floorDepth = depth;
                origin = objectOrigin;
                direction = objectDirection;
                inverse = safeInverse(direction);
                shear = rayShear(direction);
                current = uint(instance.shape);
#if HAS_CULLING
                culled = (instance.flags & VITRINE_INSTANCE_CULLED) != 0;
#endif
            }
#endif
        }
#if HAS_FILTERS
        // A loop, because the lanes of a CPU skip nothing else.
        while (pending && mayLoop()) {
            pending = false;
            Barrier barrier = loadBarrier(candidate, ray);
#if TRACE_ANY
            bool stops = weaken(barrier, candidate, passed, depth3, inside);
#else
            bool stops = stopsRay(barrier, candidate);
#endif
            if (stops) {
                best = candidate;
                tBest = recordDistance(candidate);
            } else if (!insideMesh) {
                // Through the field's surface, and on.
                fieldStart = recordDistance(candidate);
                current = fieldLeaf;
            }
        }
#endif
#if TRACE_ANY
        if (isSurface(best)) break;
#endif
        if (!insideMesh && current == kNowhere) {
            if (depth == 0) break;
            depth--;
            current = stack[depth];
        }
    }
#if TRACE_ANY && HAS_FILTERS
    // What the ray ends in, it has entered and not left.
    if (tMax < kInfinity) depth3 += max(inside, 0.0) * tMax;
    transmittance *= exp(-max(depth3, 0.0));
#endif
#if HAS_CONES
#if !HAS_FILTERS
    transmittance = vec3(1.0);
#endif
    transmittance *= penumbraShare();
#endif
    return best;
}
