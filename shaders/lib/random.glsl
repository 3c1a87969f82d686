// SPDX-License-Identifier: MIT
// Random numbers without state: a hash of (pixel, sample, dimension).

// pcg4d (Jarzynski & Olano, Hash Functions for GPU Rendering, JCGT 2020).
uvec4 pcg4d(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// [0, 1): the upper 24 bits, so that rounding never gives 1.
vec2 unitFloats(uvec2 bits) { return vec2(bits >> 8u) * (1.0 / 16777216.0); }

// The R2 low-discrepancy sequence (Roberts 2018), a point of [0, 1) squared for each index.
vec2 r2(int index) { return fract(vec2(0.5) + float(index) * vec2(0.7548776662466927, 0.5698402909980532)); }

// Well spread over the samples of a pixel, unrelated between pixels and dimensions: the R2 sequence
// shifted by a hash (Cranley & Patterson 1976).
vec2 random2(ivec2 pixel, int index, int dimension, int seed) {
    uvec4 bits = pcg4d(uvec4(uint(pixel.x), uint(pixel.y), uint(dimension), uint(seed)));
    return fract(r2(index) + unitFloats(bits.xy));
}
