// SPDX-License-Identifier: MIT
// The hit record: what any finder of surfaces writes and all that shading reads. This file owns
// the packing; C++ reads it too (pack/hit_record.hpp), so it keeps to the common subset.
//
//   x  instance, or VITRINE_RECORD_MISS (the ray left the scene), or VITRINE_RECORD_NONE (no ray)
//   y  primitive of a mesh; part of a field
//   z  mesh: barycentrics u, v as 2 x 16 bit unorm; field: octahedral normal as 2 x 16 bit snorm
//   w  distance along the ray, bits of a float (unsigned textures flush no denormals)

VITRINE_INLINE uvec4 packHit(uint instance, uint primitive, uint detail, float t) {
    return uvec4(instance, primitive, detail, floatBitsToUint(t));
}

VITRINE_INLINE uvec4 missRecord() { return uvec4(VITRINE_RECORD_MISS, 0u, 0u, 0u); }
VITRINE_INLINE uvec4 noRecord() { return uvec4(VITRINE_RECORD_NONE, 0u, 0u, 0u); }

VITRINE_INLINE bool isSurface(uvec4 record) { return record.x < VITRINE_RECORD_MISS; }
VITRINE_INLINE float recordDistance(uvec4 record) { return uintBitsToFloat(record.w); }

VITRINE_INLINE uint packBarycentrics(vec2 uv) { return packUnorm2x16(uv); }
VITRINE_INLINE vec2 unpackBarycentrics(uint bits) { return unpackUnorm2x16(bits); }

// Octahedral unit vectors (Cigolle et al., A Survey of Efficient Representations for Independent
// Unit Vectors, JCGT 2014); the largest error of 2 x 16 bits is 0.004 degrees.
VITRINE_INLINE uint packNormal(vec3 n) {
    vec3 v = n / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 p = vec2(v.x, v.y);
    if (v.z < 0.0f)
        p = vec2((1.0f - abs(v.y)) * (v.x >= 0.0f ? 1.0f : -1.0f),
                 (1.0f - abs(v.x)) * (v.y >= 0.0f ? 1.0f : -1.0f));
    return packSnorm2x16(p);
}

VITRINE_INLINE vec3 unpackNormal(uint bits) {
    vec2 p = unpackSnorm2x16(bits);
    vec3 v = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
    if (v.z < 0.0f)
        v = vec3((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f),
                 (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f), v.z);
    return normalize(v);
}
