// SPDX-License-Identifier: MIT
// The `march` finder: the box of a field is drawn, and each of its pixels looks for the field in it,
// in the same way as a ray that meets the box in the tree. The depth is that which the rasteriser gives
// a mesh at this place, so that both cut each other where they should.
#define TRACE_ANY 0
#include "trace/march.glsl"
#include "trace/filter.glsl"
#include "shade/path.glsl"

// Drawn is a little more than the box: its pixels are chosen here, and not by the rasteriser.
uvec4 marchPass(ivec2 pixel, Ray ray, int number) {
    Instance instance = fetchInstance(number);
    vec3 origin = transformPoint(instance.objectFromWorld, ray.origin);
    vec3 direction = transformVector(instance.objectFromWorld, ray.direction);
    uvec4 found = missRecord();
#if HAS_FILTERS
    filterPixel = pixel;
    bool filtered = (instance.flags & VITRINE_INSTANCE_FILTERED) != 0;
    float start = 0.0;
    bool pending = true;
    while (pending && mayLoop()) {
        FieldHit hit =
            marchField(instance, number, true, origin, direction, ray.radius, start, kInfinity);
        uvec4 candidate = fieldRecord(number, instance, hit);
        bool stops = hit.hit;
        bool asked = hit.hit && filtered;
        // A loop, because the lanes of a CPU skip nothing else.
        while (asked && mayLoop()) {
            asked = false;
            stops = stopsRay(loadBarrier(candidate, ray), candidate);
        }
        if (stops) found = candidate;
        // Through the field's surface, and on.
        pending = hit.hit && !stops;
        start = hit.t;
    }
#else
    FieldHit hit = marchField(instance, number, true, origin, direction, ray.radius, 0.0, kInfinity);
    if (hit.hit) found = fieldRecord(number, instance, hit);
#endif
    return found;
}

// What the projection (pack/camera.hpp) makes of the place at distance t.
float rasterDepth(Ray ray, float t) {
    float along = t * dot(ray.direction, frame.cameraForward.xyz);
    float depth = VITRINE_NEAR_PLANE / max(along, VITRINE_NEAR_PLANE);
#if DIALECT_ES
    depth = 0.5 + 0.5 * depth;  // there clip space reaches from -1 to 1
#endif
    return depth;
}

#if COUNTERS
// x: 0, y: evaluations of the field; w: loop iterations
vec4 marchCounters() { return vec4(0.0, float(countedSteps), 0.0, float(takenLoops)); }
#endif
