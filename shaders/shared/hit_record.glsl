// SPDX-License-Identifier: MIT
// The hit record: what any finder of surfaces writes and all that shading reads. This file owns
// the packing; C++ reads it too (pack/hit_record.hpp), so it keeps to the common subset.
//
//   x  instance, or VITRINE_RECORD_MISS (the ray left the scene), or VITRINE_RECORD_NONE (no ray)
//   y  primitive of a mesh; part of a field, below its curvature (packPart)
//   z  mesh: barycentrics u, v as 2 x 16 bits; field: octahedral normal as 2 x 16 bits
//   w  distance along the ray, bits of a float (unsigned textures flush no denormals)

VITRINE_INLINE uvec4 packHit(uint instance, uint primitive, uint detail, float t) {
    return uvec4(instance, primitive, detail, floatBitsToUint(t));
}

VITRINE_INLINE uvec4 missRecord() { return uvec4(VITRINE_RECORD_MISS, 0u, 0u, 0u); }
VITRINE_INLINE uvec4 noRecord() { return uvec4(VITRINE_RECORD_NONE, 0u, 0u, 0u); }

VITRINE_INLINE bool isSurface(uvec4 record) { return record.x < VITRINE_RECORD_MISS; }
VITRINE_INLINE float recordDistance(uvec4 record) { return uintBitsToFloat(record.w); }

// A field's part, and in the upper half the upper half of its curvature's bits (1/m, positive where it
// bulges): eight digits of a float; zero where nobody asks for it.
VITRINE_INLINE uint packPart(int part, float curvature) {
    uint bits = floatBitsToUint(curvature) + 0x8000u;
    return uint(clamp(part, 0, 0xffff)) | (bits & 0xffff0000u);
}
VITRINE_INLINE uint fieldPart(uvec4 record) { return record.y & 0xffffu; }
VITRINE_INLINE float fieldCurvature(uvec4 record) { return uintBitsToFloat(record.y & 0xffff0000u); }

// Written out, because GLSL 4.10 has no packUnorm2x16.
VITRINE_INLINE uint packBarycentrics(vec2 uv) {
    uint u = uint(clamp(uv.x, 0.0f, 1.0f) * 65535.0f + 0.5f);
    uint v = uint(clamp(uv.y, 0.0f, 1.0f) * 65535.0f + 0.5f);
    return u | (v << 16u);
}

VITRINE_INLINE vec2 unpackBarycentrics(uint bits) {
    return vec2(float(bits & 0xffffu), float(bits >> 16u)) / 65535.0f;
}

// Octahedral unit vectors (Cigolle et al., A Survey of Efficient Representations for Independent
// Unit Vectors, JCGT 2014); the largest error of 2 x 16 bits is 0.004 degrees.
VITRINE_INLINE uint packNormal(vec3 n) {
    vec3 v = n / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 p = vec2(v.x, v.y);
    if (v.z < 0.0f)
        p = vec2((1.0f - abs(v.y)) * (v.x >= 0.0f ? 1.0f : -1.0f),
                 (1.0f - abs(v.x)) * (v.y >= 0.0f ? 1.0f : -1.0f));
    // Steps of 1/32767 on both sides of an exact zero: the axes stay exact.
    uint x = uint(p.x * 32767.0f + 32767.5f);
    uint y = uint(p.y * 32767.0f + 32767.5f);
    return x | (y << 16u);
}

VITRINE_INLINE vec3 unpackNormal(uint bits) {
    vec2 p = (vec2(float(bits & 0xffffu), float(bits >> 16u)) - vec2(32767.0f)) / 32767.0f;
    vec3 v = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
    if (v.z < 0.0f)
        v = vec3((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f),
                 (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f), v.z);
    return normalize(v);
}
