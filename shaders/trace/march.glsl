// SPDX-License-Identifier: MIT
// Sphere tracing (Hart 1996) of one field inside its box, in object space, with the ray's own
// parameter t: an object-space distance d allows a step of d / |direction| whatever the transform.
// The way is counted from the box on: counted from a far eye, the last steps would be rounded away.
//
// The surface normal is found in the same loop (tetrahedron rule, Quilez), so that the field is
// called from a single place: compilers inline each call, and a second one doubles their work.
#include "scene/fetch.glsl"
#include "lib/hit_record.glsl"
#include "generated/field.glsl"

#if HAS_CURVATURE && !TRACE_ANY
#define FIND_CURVATURE 1
#else
#define FIND_CURVATURE 0
#endif

struct FieldHit {
    bool hit;
    float t;
    int part;
    vec3 normal;  // object space, unit; zero where a shadow ray asked
    float curvature;  // mean, 1/m in the world; 0 where nobody asks
};

const int kMostSteps = 4096;  // of one march: an eighth of what all loops of a pixel may take

const int kMarching = 0;
const int kProbing = 1;  // four evaluations around the hit
const int kFinished = 2;
#if FIND_CURVATURE
const int kBending = 3;  // four more, along the surface
const int kProbes = 8;
#else
const int kProbes = 4;
#endif

vec3 tetrahedronCorner(int i) {
    return vec3((i & 1) == 0 ? 1.0 : -1.0, (i & 2) == 0 ? 1.0 : -1.0, i == 0 || i == 3 ? 1.0 : -1.0);
}

// Enters and leaves the box; empty if x > y.
vec2 boxInterval(vec3 boxMin, vec3 boxMax, vec3 origin, vec3 inverse) {
    vec3 a = (boxMin - origin) * inverse;
    vec3 b = (boxMax - origin) * inverse;
    vec3 low = min(a, b);
    vec3 high = max(a, b);
    return vec2(max(max(low.x, low.y), max(low.z, 0.0)), min(high.x, min(high.y, high.z)));
}

// `origin` and `direction` in object space; `radius` is the pixel cone's in the world at t = 0.
// `number`: of the instance. `tStart`: above 0 the ray stands on the surface there, which let it pass. Fields that let rays pass
// are marched from whatever side the ray is on; others hold what starts in them.
FieldHit marchField(Instance instance, int number, bool wanted, vec3 origin, vec3 direction, float radius,
                    float tStart, float tMax) {
    FieldHit result = FieldHit(false, tMax, 0, vec3(0.0), 0.0);
#if HAS_CONES
    bool passes = (instance.flags & VITRINE_INSTANCE_FILTERED) != 0;
    bool cone = coneAsks == kAskPenumbra && !passes;
    bool taps = coneAsks == kAskTaps;
    bool own = taps && number == coneOwner;
    wanted = wanted && !(taps && passes);
    vec3 margin = cone || taps ? coneMargin(instance, origin, direction, tMax) : vec3(0.0);
    vec2 interval = boxInterval(instance.boxMin - margin, instance.boxMax + margin, origin,
                                safeInverse(direction));
    if (taps && interval.x <= min(interval.y, tMax)) interval = vec2(0.0, tMax);
    float worldPerObject = 1.0 / length(direction);
    float slopeProbe = 0.0;
    float first = 0.0;        // of the field that the taps start on: its value there, and its
    float slope = 1.0;        // slope, which need not be one
    float lastDistance = 0.0;
    float lastStep = 0.0;
#else
    vec2 interval = boxInterval(instance.boxMin, instance.boxMax, origin, safeInverse(direction));
#endif
    interval.x = max(interval.x, tStart);
    float tEnd = min(interval.y, tMax);
    vec3 entry = origin + interval.x * direction;
    float t = interval.x;
    float way = 0.0;  // t - interval.x
    float stepPerDistance = instance.stepScale / length(direction);
    // A length in the world is at least this long in here, whatever its direction: rays that leave a
    // squeezed object must not find it again.
    float objectPerWorld = min(length(instance.objectFromWorld[0].xyz),
                               min(length(instance.objectFromWorld[1].xyz),
                                   length(instance.objectFromWorld[2].xyz)));
    int state = wanted && t <= tEnd ? kMarching : kFinished;
#if HAS_CONES
    slopeProbe = max(2.0 * radius, max(0.005 * tMax, 50.0 * instance.finest / objectPerWorld));
    if (taps) way = tapPlace(own ? 0 : 2, slopeProbe, tMax);
#endif
    bindField(instance.shape, instance.parameters);
    int probes = 0;
    float tolerance = 0.0;
#if HAS_FILTERS
    bool passable = (instance.flags & VITRINE_INSTANCE_FILTERED) != 0;
    bool leaving = tStart > 0.0;
    float side = 1.0;
#endif
    vec3 gradient = vec3(0.0);
#if FIND_CURVATURE
    // By how much the field around the hit, in the plane that touches the surface, is larger than at
    // the hit: half its second derivatives along the plane, and those add up to twice the mean
    // curvature times the slope. On a cross of this radius, not in a limit, so that edges have a width.
    float reach = 0.0;
    vec3 along = vec3(0.0);
    vec3 across = vec3(0.0);
    float steepness = 1.0;
    float centre = 0.0;
    float around = 0.0;
#endif
    // A field that needs shorter steps gets more of them.
    int mostSteps = min(int(float(frame.counts.y) / clamp(instance.stepScale, 1.0e-3, 1.0)), kMostSteps);
    // The last step may still be followed by its probes: a normal from fewer would be nonsense.
    for (int i = 0; i < mostSteps + kProbes; i++) {
        if (state == kFinished || (state == kMarching && i >= mostSteps) || !mayLoop()) break;
        COUNT(countedSteps);
        vec3 p = entry + way * direction;
        vec3 corner = tetrahedronCorner(probes);
        bool probing = state == kProbing;
        // Wide enough that the differences stand out of the rounding.
        float probe = max(tolerance, 16.0 * instance.finest);
        if (probing) p += corner * probe;
#if FIND_CURVATURE
        bool bending = state == kBending;
        if (bending) p += (probes > 5 ? across : along) * ((probes & 1) == 0 ? reach : -reach);
#endif
        vec2 d = evaluateField(instance.shape, p);
        // A field that is not a number is a miss: nothing can be said about the surface.
        if (isnan(d.x) && !probing) state = kFinished;
#if FIND_CURVATURE
        bool landed = false;
#endif
#if HAS_CONES
        // A field ends at its box, and outside of it means nothing.
        float outside = distanceToBox(p, instance.boxMin, instance.boxMax);
        if ((cone || taps) && outside > 0.0) d.x = max(d.x, outside);
        int tap = own ? i : i + 2;
        if (taps && state != kFinished) {
            if (tap == 0) first = d.x;
            if (tap == 1) slope = max((d.x - first) / slopeProbe, 0.05 * objectPerWorld);
            if (tap >= 2) takeTap(tap - 2, own ? (d.x - first) / slope : d.x * worldPerObject);
            way = tapPlace(tap + 1, slopeProbe, tMax);
            if (tap == kTapSteps - 1) state = kFinished;
        } else
#endif
#if FIND_CURVATURE
        if (bending) {
            around += d.x - centre;
            probes++;
            if (probes == kProbes) state = kFinished;
        } else
#endif
        if (probing) {
            gradient += corner * d.x;
            probes++;
            if (probes == 4) state = kFinished;
#if FIND_CURVATURE
            landed = probes == 4;
#endif
        } else {
            // A twentieth of the pixel's radius: below what mirror images show, above what floats lose.
            tolerance = max(instance.finest,
                            0.05 * (radius + frame.cameraEye.w * t) * objectPerWorld);
            float free = d.x;
            bool hit = d.x < tolerance;
#if HAS_FILTERS
            if (passable && (i == 0 || leaving)) side = d.x < 0.0 ? -1.0 : 1.0;
            leaving = leaving && abs(d.x) < tolerance;
            free = leaving ? tolerance : side * d.x;
            hit = free < tolerance;
#endif
            if (hit) {
                // What is left is free as well: a ray that comes straight ends on the surface.
                result.t = t + max(free, 0.0) * stepPerDistance;
                // Or on what stands before it, whichever of both was found first.
                result.hit = result.t <= tMax;
                result.part = int(d.y + 0.5);
#if FIND_CURVATURE
                centre = d.x;
#endif
#if TRACE_ANY && HAS_FILTERS
                state = passable ? kProbing : kFinished;
#elif TRACE_ANY
                state = kFinished;
#else
                state = kProbing;
#endif
            } else {
#if HAS_CONES
                if (cone) {
                    passNear(free * worldPerObject, t, lastDistance, lastStep);
                    lastDistance = free * worldPerObject;
                    lastStep = free * stepPerDistance;
                }
#endif
                way += free * stepPerDistance;
                t = interval.x + way;
                if (t > tEnd) state = kFinished;
            }
        }
#if FIND_CURVATURE
        // A loop, because the lanes of a CPU skip nothing else.
        while (landed && mayLoop()) {
            landed = false;
            int list = instance.materials;
            int part = clamp(result.part, 0, int(fetchTable(list).y) - 1);
            reach = fetchTable(list + part).z * objectPerWorld;
            // Nearer, the differences would drown in the rounding.
            if (reach > 0.0) reach = max(reach, 512.0 * instance.finest);
            steepness = length(gradient) / (4.0 * probe);
            state = reach > 0.0 && steepness > 0.0 ? kBending : kFinished;
            orthonormalBasis(gradient / max(length(gradient), 1.0e-30), along, across);
        }
#endif
    }
#if FIND_CURVATURE
    float bend = around / (2.0 * max(steepness, 1.0e-3) * square(max(reach, 1.0e-12)));
    if (abs(bend) < 1.0e6) result.curvature = bend * objectPerWorld;  // nor NaN
#endif
    float size = length(gradient);
    result.normal = size > 0.0 ? gradient / size : -normalize(direction);
    return result;
}

uvec4 fieldRecord(int number, Instance instance, FieldHit hit) {
    vec3 n = transformNormal(instance.objectFromWorld, hit.normal);
    return packHit(uint(number), packPart(hit.part, hit.curvature), packNormal(normalize(n)), hit.t);
}
