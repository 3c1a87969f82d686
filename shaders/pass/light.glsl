// SPDX-License-Identifier: MIT
// Light that leaves each hit towards the path: emission, all lights with hard shadows, and ambient
// light with rays for its occlusion. One loop, one place where shadow rays are traced.
#define TRACE_ANY 1
#include "trace/trace.glsl"
#include "shade/path.glsl"
#include "shade/surface.glsl"
#include "shade/environment.glsl"
#include "shade/lights.glsl"
#include "shade/reflection.glsl"
#include "shade/counters.glsl"

uniform sampler2D radianceBefore;

// A look for light: where to, how far, and what arrives if nothing is in the way or something is.
struct Probe {
    vec3 direction;
    float distance;
    vec3 open;
    vec3 blocked;
};

Probe ambientProbe(Hit hit, ivec2 pixel, int index, int count) {
    Surface s = hit.surface;
    vec3 albedo = ambientAlbedo(s) * s.occlusion / float(count);
    float ao = frame.shading.z;
    if (ao <= 0.0) return Probe(s.normal, 0.0, albedo * environmentRadiance(s.normal), vec3(0.0));
    int sampleIndex = frame.sampling.x * count + index;
    vec3 local = sampleCosine(random2(pixel, sampleIndex, frame.sampling.y * count,
                                      kDimensionAmbient + frame.sampling.z, frame.sampling.w));
    vec3 tangent, bitangent;
    orthonormalBasis(s.normal, tangent, bitangent);
    vec3 direction = local.x * tangent + local.y * bitangent + local.z * s.normal;
    vec3 radiance = albedo * environmentRadiance(direction);
    return Probe(direction, frame.shading.w, radiance, radiance * (1.0 - ao));
}

vec3 shade(uvec4 record, Path path, ivec2 pixel) {
    Hit hit = loadHit(record, path.ray);
    vec3 toViewer = -path.ray.direction;
    bool shadowView = frame.image.w == VITRINE_VIEW_SHADOW;
    int lights = frame.counts.x;
    int ambient = shadowView || isReference() ? 0 : max(1, int(frame.display.w) / (frame.sampling.z == 0 ? 1 : 4));
    vec3 ambientSum = vec3(0.0);
    vec3 sum = shadowView ? vec3(0.0) : hit.surface.emission;
    for (int i = 0; i < lights + ambient; i++) {
        if (!mayLoop()) break;
        Probe probe;
        if (i < lights) {
            LightSample light = sampleLight(i, hit.surface.position);
            vec3 answer = evaluateReflection(hit.surface, toViewer, light.direction,
                                             max(path.blur, kLeastLightAlpha), true).value *
                          light.irradiance;
            if (shadowView) answer = vec3(answer == vec3(0.0) ? 0.0 : 1.0 / float(lights));
            probe = Probe(light.direction, light.distance, answer, vec3(0.0));
        } else {
            probe = ambientProbe(hit, pixel, i - lights, ambient);
        }
        float distance = maxComponent(probe.open) > 0.0 ? probe.distance : 0.0;
        uvec4 obstacle = missRecord();
        if (distance > 0.0)
            obstacle = trace(Ray(hit.rayOrigin, probe.direction, hit.radius), distance);
        vec3 light = isSurface(obstacle) || distance <= 0.0
                         ? probe.blocked
                         : mix(probe.blocked, probe.open, transmittance);
        if (i < lights) sum += light;
        else ambientSum += light;
    }
    // More occlusion than is natural (ao above 1) must not take away other light.
    return hit.way * (sum + max(ambientSum, 0.0));
}

vec4 lightPass(ivec2 pixel) {
    uvec4 record = texelFetch(records, pixel, 0);
    vec3 before = texelFetch(radianceBefore, pixel, 0).rgb;
    if (record.x == VITRINE_RECORD_NONE) return vec4(before, 1.0);
    Path path = loadPath(pixel);
    vec3 radiance = vec3(0.0);
    if (isSurface(record))
        radiance = shade(record, path, pixel);
    else if (frame.image.w != VITRINE_VIEW_SHADOW)
        radiance = environmentRadiance(path.ray.direction);
    return vec4(before + path.throughput * radiance, 1.0);
}

#if COUNTERS
uvec4 lightCounters(ivec2 pixel) {
    return addCounters(texelFetch(countersBefore, pixel, 0), 1u);
}
#endif
