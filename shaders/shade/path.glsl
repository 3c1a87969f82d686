// SPDX-License-Identifier: MIT
// The state of a path between passes. The camera ray is computed, later rays are stored.
#include "scene/fetch.glsl"
#include "lib/hit_record.glsl"
#include "lib/random.glsl"
#include "shade/lens.glsl"

uniform usampler2D records;
uniform sampler2D pathOrigin;      // xyz: origin; w: radius of the cone
uniform sampler2D pathDirection;   // xyz: unit; w: blur
uniform sampler2D pathThroughput;  // rgb; w: pdf

struct Path {
    Ray ray;
    vec3 throughput;
    float blur;  // width of the highlights that can be told from noise along this path
                 // (after Jendersie & Grosch, Microfacet Model Regularization, EGSR 2019)
    float pdf;   // density, a steradian, with which the last bounce took this direction; 0: it had
                 // no choice (camera ray, mirror, glass), and nothing else finds what lies there;
                 // below 0: what is bright there has been found already (pass/bounce.glsl)
};

// Uses of random numbers, so that no two share one.
const int kDimensionLens = 8;
const int kDimensionAmbient = 16;  // and 15 more
const int kDimensionSky = 32;      // and 15 more
const int kDimensionBounce = 64;   // and one a bounce
const int kDimensionChoice = 128;  // and one a bounce: of a lobe, and whether the path goes on
const int kDimensionSubstance = 192;  // and one a bounce; 32 kinds of probes share the points
const int kDimensionLights = 256;  // and 31 more a light, of which there are 32 kinds

// For what takes one point a sample.
vec2 random2(ivec2 pixel, int sampleIndex, int dimension, int seed) {
    return random2(pixel, sampleIndex, frame.sampling.y, dimension, seed);
}

// The ray that looks for what this pixel shows in this sample.
Ray pixelRay(ivec2 pixel) {
    Ray ray = cameraRay(vec2(pixel) + 0.5 + frame.jitter.xy);
    bool pending = frame.lens.x > 0.0;
    // A loop, because the lanes of a CPU skip nothing else.
    while (pending && mayLoop()) {
        pending = false;
        ray = throughLens(ray, random2(pixel, frame.sampling.x, kDimensionLens, frame.sampling.w));
    }
    return ray;
}

Path loadPath(ivec2 pixel) {
    if (frame.sampling.z == 0) return Path(pixelRay(pixel), vec3(1.0), 0.0, 0.0);
    vec4 origin = texelFetch(pathOrigin, pixel, 0);
    vec4 direction = texelFetch(pathDirection, pixel, 0);
    vec4 throughput = texelFetch(pathThroughput, pixel, 0);
    return Path(Ray(origin.xyz, direction.xyz, origin.w), throughput.rgb, direction.w, throughput.w);
}
