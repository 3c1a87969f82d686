// SPDX-License-Identifier: MIT
// From each hit to the next: the mirror image of what lies on the way, or what is seen through glass.
// A path ends when less than `threshold` of its light would arrive; in reference mode by chance.
#define TRACE_ANY 0
#include "trace/trace.glsl"
#include "shade/path.glsl"
#include "shade/surface.glsl"
#include "shade/next_ray.glsl"
#include "shade/counters.glsl"

// In reference mode no path ends by chance before.
const int kSafeBounces = 3;

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
#if HAS_FILTERS
    filterPixel = pixel;
#endif
    int bounce = frame.sampling.z;
    vec2 u = random2(pixel, frame.sampling.x, kDimensionBounce + bounce, frame.sampling.w);
    vec2 choice = random2(pixel, frame.sampling.x, kDimensionChoice + bounce, frame.sampling.w);
    NextRay next = sampleNextRay(hit.surface, -path.ray.direction, u, choice.x);
    vec3 throughput = path.throughput * hit.way * next.weight;
    float left = maxComponent(throughput);
    float least = frame.shading.y;
    if (isReference()) {
        // Russian roulette. Never a NaN's way on.
        float chance = bounce < kSafeBounces ? 1.0 : clamp(left, 0.05, 1.0);
        throughput = choice.y < chance ? throughput / chance : vec3(0.0);
        left = maxComponent(throughput);
        least = 0.0;
    }
    if (!(left >= max(least, 1.0e-6))) return ended;
    Ray ray = Ray(next.through ? hit.behind : hit.rayOrigin, next.direction, hit.radius);
    float blur = isReference() ? 0.0 : max(path.blur, highlightBlur(next.alpha));
    // Seen by a blurred path, lights and the bright sky have been taken in with a lobe as wide as the
    // blur where this ray starts, or mirrors in rough surfaces would sparkle with images of the sun.
    // This ray looks for none, which a density below zero says.
    float pdf = path.blur > 0.0 ? -max(next.pdf, 1.0 / (kPi * square(path.blur))) : next.pdf;
    return Bounce(trace(ray, kInfinity), vec4(ray.origin, ray.radius), vec4(ray.direction, blur),
                  vec4(throughput, pdf));
}

#if COUNTERS
uvec4 bounceCounters(ivec2 pixel) {
    return addCounters(texelFetch(countersBefore, pixel, 0), 65536u);
}
#endif
