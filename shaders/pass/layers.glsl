// SPDX-License-Identifier: MIT
// What the first hits say, as data for compositing: numbers, reflected colour, normal and depth.
#include "shade/path.glsl"
#include "shade/surface.glsl"

struct Layers {
    uvec4 ids;     // instance, primitive or part, material; all bits set: no surface
    vec4 albedo;   // linear rgb
    vec4 normal;   // xyz: world space, unit, towards the viewer; w: depth along the view axis, m
};

Layers layersPass(ivec2 pixel) {
    uvec4 record = texelFetch(records, pixel, 0);
    if (!isSurface(record)) return Layers(uvec4(VITRINE_RECORD_NONE), vec4(0.0), vec4(0.0));
    Ray ray = pixelRay(pixel);
    Hit hit = loadHit(record, ray);
    float depth = recordDistance(record) * dot(ray.direction, frame.cameraForward.xyz);
    return Layers(uvec4(record.x, numberOf(record), uint(hit.material), 0u), vec4(hit.surface.baseColor, 1.0),
                  vec4(hit.surface.normal, depth));
}
