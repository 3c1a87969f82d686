// SPDX-License-Identifier: MIT
// Points in the unit square for each pixel, sample and use ("dimension"). C++ reads this file too
// (pack/sampler.hpp), so it keeps to the common subset.
//
// The points are the first two dimensions of Sobol's sequence, shuffled and scrambled after Owen by
// hashes (Burley, Practical Hash-based Owen Scrambling, JCGT 2020). Pixels share one sequence: its
// index is the pixel's Morton code followed by the number of the sample (Ahmed & Wonka, Screen-space
// blue-noise diffusion of Monte Carlo sampling error via hierarchical ordering of pixels, SIGGRAPH
// Asia 2020). So the samples of each pixel, and those of every aligned square of 2^k by 2^k pixels
// together, are (0,m,2)-nets: what one pixel gets wrong its neighbours make up for.

// pcg4d (Jarzynski & Olano, Hash Functions for GPU Rendering, JCGT 2020).
VITRINE_INLINE uvec4 pcg4d(uvec4 v) {
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

VITRINE_INLINE uint reverseBits(uint x) {
#if DIALECT_ES
    x = ((x >> 1u) & 0x55555555u) | ((x & 0x55555555u) << 1u);
    x = ((x >> 2u) & 0x33333333u) | ((x & 0x33333333u) << 2u);
    x = ((x >> 4u) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4u);
    x = ((x >> 8u) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8u);
    return (x >> 16u) | (x << 16u);
#else
    return bitfieldReverse(x);
#endif
}

// Flips each bit or not by what the bits below it and the seed say: Owen's scrambling of the number
// with its bits reversed. The hash of Laine & Karras (2011) with the constants of Vegdahl (Building
// a Better LK Hash, 2021).
VITRINE_INLINE uint scrambleReversed(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// The low 16 bits of x and y in turn: pixels in Z order.
VITRINE_INLINE uint mortonCode(uint x, uint y) {
    uint low = (x & 0xffffu) | (y << 16u);
    low = (low & 0xff0000ffu) | ((low & 0x00ff0000u) >> 8u) | ((low & 0x0000ff00u) << 8u);
    low = (low & 0xf00ff00fu) | ((low & 0x0f000f00u) >> 4u) | ((low & 0x00f000f0u) << 4u);
    low = (low & 0xc3c3c3c3u) | ((low & 0x30303030u) >> 2u) | ((low & 0x0c0c0c0cu) << 2u);
    return (low & 0x99999999u) | ((low & 0x44444444u) >> 1u) | ((low & 0x22222222u) << 1u);
}

// The second dimension of Sobol's sequence, bits reversed: Pascal's triangle modulo 2, which is a
// Kronecker power of its first two rows (Ahmed, An Implementation Algorithm of 2D Sobol Sequence
// Fast, Elegant, and Compact, EGSR 2024). The first dimension, bits reversed, is the index.
VITRINE_INLINE uint sobolReversed(uint index) {
    index ^= (index & 0xaaaaaaaau) >> 1u;
    index ^= (index & 0xccccccccu) >> 2u;
    index ^= (index & 0xf0f0f0f0u) >> 4u;
    index ^= (index & 0xff00ff00u) >> 8u;
    return index ^ (index >> 16u);
}

// Bits of numbers below `count`.
VITRINE_INLINE uint bitsBelow(uint count) {
    // By the exponent of a float: GLSL ES 3.00 has no findMSB().
    int exponent = int(floatBitsToUint(float(count - 1u)) >> 23u) - 126;
    return uint(max(exponent, 0));
}

// Point `index` of `count` of a pixel, in 32 bits a coordinate. The samples beyond `count` are as
// good, but unrelated to the first ones.
VITRINE_INLINE uvec2 sampleBits(uvec2 pixel, uint index, uint count, uint dimension, uint seed) {
    uint bits = bitsBelow(count);
    uint block = index >> bits;
    uvec4 seeds = pcg4d(uvec4(dimension, seed, block, 0u));
    // High bits that fall out at the left only repeat the pattern in tiles of many pixels.
    uint i = (mortonCode(pixel.x, pixel.y) << bits) | (index - (block << bits));
    i = reverseBits(scrambleReversed(reverseBits(i), seeds.x));
    return uvec2(reverseBits(scrambleReversed(i, seeds.y)),
                 reverseBits(scrambleReversed(sobolReversed(i), seeds.z)));
}
