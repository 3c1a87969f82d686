// SPDX-License-Identifier: MIT
// Random numbers without state, for each (pixel, sample, dimension, seed).
#define VITRINE_INLINE
#include "shared/sampler.glsl"

// [0, 1): the upper 24 bits, so that rounding never gives 1.
vec2 unitFloats(uvec2 bits) { return vec2(bits >> 8u) * (1.0 / 16777216.0); }

// Point `index` of `count` that the pixel uses in all samples for this dimension: see
// shared/sampler.glsl. Well spread over the samples of a pixel and over neighbouring pixels.
vec2 random2(ivec2 pixel, int index, int count, int dimension, int seed) {
    return unitFloats(sampleBits(uvec2(pixel), uint(index), uint(count), uint(dimension), uint(seed)));
}
