// SPDX-License-Identifier: MIT
// The first step of the lens filter: the picture's light with the radius of each pixel's circle of
// confusion, at the levels of shade/circles.glsl.
#include "shade/circles.glsl"
#include "lib/hit_record.glsl"

uniform sampler2D mean;
uniform usampler2D records;

struct FocusLevels {
    vec4 light;   // rgb; w: radius, pixels, below 0 in front of what is sharp
    vec4 extent;  // x: share of the texel's pixels that are of the level's band; y: bands there are, a bit each;
                  // zw: from the texel's middle to the middle of those pixels
};

float radiusAt(ivec2 pixel) {
    uvec4 record = texelFetch(records, pixel, 0);
    vec3 direction = cameraRay(vec2(pixel) + 0.5 + frame.jitter.xy).direction;
    float depth = recordDistance(record) * dot(direction, frame.cameraForward.xyz);
    return circleRadius(isSurface(record) ? depth : kInfinity);
}

FocusLevels focusLevelsPass(ivec2 texel) {
    int level = 0;
    for (int i = 1; i < kBands - 1; i++) {
        if (!mayLoop()) break;
        if (all(greaterThanEqual(texel, levelCorner(i)))) level = i;
    }
    ivec2 place = texel - levelCorner(level);
    int side = 1 << level;
    int bands = 0;
    // What is nearer than the sharp may have circles as wide as what is farther, but the mean of both
    // is neither: a texel with both keeps the near.
    vec4 nearLight = vec4(0.0);
    vec4 farLight = vec4(0.0);
    vec3 nearPlace = vec3(0.0);  // xy: sum of places; z: how many
    vec3 farPlace = vec3(0.0);
    int pixels = all(lessThan(place, levelSize(level))) ? side * side : 0;
    for (int i = 0; i < pixels; i++) {
        if (!mayLoop()) break;
        ivec2 pixel = place * side + ivec2(i % side, i / side);
        if (any(greaterThanEqual(pixel, frame.image.xy))) continue;
        float radius = radiusAt(pixel);
        int band = bandOf(abs(radius));
        bands |= 1 << band;
        if (level > 0 && levelOfBand(band) != level) continue;
        vec4 light = vec4(texelFetch(mean, pixel, 0).rgb, radius);
        vec3 at = vec3(vec2(i % side, i / side) - 0.5 * float(side - 1), 1.0);
        nearLight += radius < 0.0 ? light : vec4(0.0);
        nearPlace += radius < 0.0 ? at : vec3(0.0);
        farLight += radius < 0.0 ? vec4(0.0) : light;
        farPlace += radius < 0.0 ? vec3(0.0) : at;
    }
    bool near = nearPlace.z > 0.0;
    vec3 kept = near ? nearPlace : farPlace;
    float found = max(kept.z, 1.0);
    FocusLevels result;
    result.light = (near ? nearLight : farLight) / found;
    result.extent = vec4(kept.z / float(side * side), float(bands), kept.xy / found);
    return result;
}
