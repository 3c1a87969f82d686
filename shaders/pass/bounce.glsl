// SPDX-License-Identifier: MIT
// From each hit to the next: the mirror image of what lies on the way. A path ends when less than
// `threshold` of its light would arrive.
#define TRACE_ANY 0
#include "trace/trace.glsl"
#include "shade/path.glsl"
#include "shade/surface.glsl"
#include "shade/reflection.glsl"
#include "shade/counters.glsl"

struct Bounce {
    uvec4 record;
    vec4 origin;      // as stored, see shade/path.glsl
    vec4 direction;
    vec4 throughput;
};

Bounce bouncePass(ivec2 pixel) {
    Bounce ended = Bounce(noRecord(), vec4(0.0), vec4(0.0), vec4(0.0));
    uvec4 record = texelFetch(records, pixel, 0);
    if (!isSurface(record)) return ended;
    Path path = loadPath(pixel);
    Hit hit = loadHit(record, path.ray);
    vec2 u = random2(pixel, frame.sampling.x, kDimensionBounce + frame.sampling.z, frame.sampling.w);
    NextRay next = sampleReflection(hit.surface, hit.geometricNormal, -path.ray.direction, u);
    vec3 throughput = path.throughput * next.weight;
    if (maxComponent(throughput) < max(frame.shading.y, 1.0e-6)) return ended;
    Ray ray = Ray(hit.rayOrigin, next.direction, hit.radius);
    return Bounce(trace(ray, kInfinity), vec4(ray.origin, ray.radius), 
                  vec4(ray.direction, max(path.blur, highlightBlur(hit.surface))),
                  vec4(throughput, 1.0));
}

#if COUNTERS
uvec4 bounceCounters(ivec2 pixel) {
    return addCounters(texelFetch(countersBefore, pixel, 0), 65536u);
}
#endif
