// SPDX-License-Identifier: MIT
// The one question that every ray asks: what is there? Meshes and fields stand in one two-level
// tree; a leaf of the upper level is a mesh with a tree of its own, or the box of a field.
// Defines: TRACE_ANY (1: is there anything at all), HAS_MESHES, HAS_FIELDS.
//
// The loops have the shape that pays on CPUs that run 8 pixels in lockstep and skip nothing:
// - one inner loop walks both levels. Its step reads three texels that are a node or a triangle
//   and does both tests, because a branch not taken costs as much as one taken;
// - what happens once an instance (its transform, the march of a field) stands outside of it.
#include "trace/node.glsl"
#include "trace/triangle.glsl"
#include "lib/hit_record.glsl"
#if HAS_FIELDS
#include "trace/march.glsl"
#endif

const uint kNowhere = 0xffffffffu;

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
                uvec4 keys = intersectChildren(slot, origin, inverse, tBest);
                if (keys.w != kNoChild) stack[depth++] = childOf(slot, keys.w);
                if (keys.z != kNoChild) stack[depth++] = childOf(slot, keys.z);
                if (keys.y != kNoChild) stack[depth++] = childOf(slot, keys.y);
                pop = keys.x == kNoChild;
                current = childOf(slot, keys.x);
            } else {
#if HAS_MESHES
                float t;
                vec2 barycentrics;
                if (intersectTriangle(origin, shear, uintBitsToFloat(slot.a.xyz),
                                      uintBitsToFloat(slot.b.xyz), uintBitsToFloat(slot.c.xyz),
                                      tBest, t, barycentrics)) {
                    tBest = t;
                    best = packHit(uint(instanceIndex), slot.a.w & ~VITRINE_LAST_TRIANGLE_BIT,
                                   packBarycentrics(barycentrics), t);
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
        }
#if TRACE_ANY
        if (isSurface(best)) break;
#endif
        if (current == kNowhere) {
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
        if (current == kNowhere) break;
        if ((current & VITRINE_LEAF_BIT) != 0u) {
            // A leaf of the upper level names its instance in its slot.
            instanceIndex = int(fetchSlot(int(current & ~VITRINE_LEAF_BIT)).a.x);
            Instance instance = fetchInstance(instanceIndex);
            vec3 objectOrigin = transformPoint(instance.objectFromWorld, ray.origin);
            vec3 objectDirection = transformVector(instance.objectFromWorld, ray.direction);
            current = kNowhere;
#if HAS_FIELDS
            FieldHit field = marchField(instance, instance.kind == VITRINE_KIND_FIELD, objectOrigin,
                                        objectDirection, ray.radius, tBest);
            if (field.hit) {
                tBest = field.t;
                vec3 n = transformNormal(instance.objectFromWorld, field.normal);
                best = packHit(uint(instanceIndex), uint(field.part), packNormal(normalize(n)),
                               field.t);
            }
#endif
#if HAS_MESHES
            if (instance.kind == VITRINE_KIND_MESH) {
                insideMesh = true;
                floorDepth = depth;
                origin = objectOrigin;
                direction = objectDirection;
                inverse = safeInverse(direction);
                shear = rayShear(direction);
                current = uint(instance.shape);
            }
#endif
#if TRACE_ANY
            if (isSurface(best)) break;
#endif
            if (current == kNowhere && depth > 0) {
                depth--;
                current = stack[depth];
            }
            if (current == kNowhere) break;
        }
    }
    return best;
}
