// SPDX-License-Identifier: MIT
// Four floats that go through one instruction where SSE2 exists (every x86-64), and through four
// elsewhere. Only what the builder needs; both forms give the same bits.
#pragma once

#include <bit>
#include <cstdint>
#include <utility>

#include "base/math.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace vitrine {

#if defined(__SSE2__)

struct Float4 {
    __m128 v;

    static Float4 of(float x, float y, float z, float w) { return {_mm_setr_ps(x, y, z, w)}; }
    static Float4 splat(float x) { return {_mm_set1_ps(x)}; }
};

inline Float4 operator+(Float4 a, Float4 b) {
    return {_mm_add_ps(a.v, b.v)};
}
inline Float4 operator-(Float4 a, Float4 b) {
    return {_mm_sub_ps(a.v, b.v)};
}
inline Float4 operator*(Float4 a, Float4 b) {
    return {_mm_mul_ps(a.v, b.v)};
}
/// If either is NaN, the result is b.
inline Float4 min(Float4 a, Float4 b) {
    return {_mm_min_ps(a.v, b.v)};
}
inline Float4 max(Float4 a, Float4 b) {
    return {_mm_max_ps(a.v, b.v)};
}
/// All bits set in the lanes where it holds.
inline Float4 less(Float4 a, Float4 b) {
    return {_mm_cmplt_ps(a.v, b.v)};
}
/// Its exact opposite: true where either is NaN.
inline Float4 notLess(Float4 a, Float4 b) {
    return {_mm_cmpnlt_ps(a.v, b.v)};
}
inline Float4 select(Float4 mask, Float4 yes, Float4 no) {
    return {_mm_or_ps(_mm_and_ps(mask.v, yes.v), _mm_andnot_ps(mask.v, no.v))};
}
/// Lanes where the mask is set become NaN.
inline Float4 orMask(Float4 a, Float4 mask) {
    return {_mm_or_ps(a.v, mask.v)};
}
inline bool firstLane(Float4 mask) {
    return (_mm_movemask_ps(mask.v) & 1) != 0;
}
template <int Lane>
Float4 splatLane(Float4 a) {
    return {_mm_shuffle_ps(a.v, a.v, _MM_SHUFFLE(Lane, Lane, Lane, Lane))};
}
inline void store(float* out, Float4 a) {
    _mm_storeu_ps(out, a.v);
}

/// Rows to columns of the upper left 3x3; the fourth lanes are unspecified.
inline void transpose3(Float4& a, Float4& b, Float4& c) {
    const __m128 low = _mm_unpacklo_ps(a.v, b.v);
    const __m128 high = _mm_unpackhi_ps(a.v, b.v);
    a.v = _mm_shuffle_ps(low, c.v, _MM_SHUFFLE(0, 0, 1, 0));
    b.v = _mm_shuffle_ps(low, c.v, _MM_SHUFFLE(1, 1, 3, 2));
    c.v = _mm_shuffle_ps(high, c.v, _MM_SHUFFLE(2, 2, 1, 0));
}

struct Int4 {
    __m128i v;

    static Int4 splat(int32_t x) { return {_mm_set1_epi32(x)}; }
};

inline Int4 operator+(Int4 a, Int4 b) {
    return {_mm_add_epi32(a.v, b.v)};
}
inline Int4 operator-(Int4 a, Int4 b) {
    return {_mm_sub_epi32(a.v, b.v)};
}
/// Rounds towards zero. Precondition: representable.
inline Int4 toInt(Float4 a) {
    return {_mm_cvttps_epi32(a.v)};
}
inline Float4 toFloat(Int4 a) {
    return {_mm_cvtepi32_ps(a.v)};
}
inline Int4 bits(Float4 a) {
    return {_mm_castps_si128(a.v)};
}
inline void store(int32_t* out, Int4 a) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out), a.v);
}
inline Int4 loadInt4(const int32_t* in) {
    return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(in))};
}

#else

struct alignas(16) Float4 {
    float v[4];

    static Float4 of(float x, float y, float z, float w) { return {{x, y, z, w}}; }
    static Float4 splat(float x) { return {{x, x, x, x}}; }
};

template <typename F>
Float4 lanes(F&& f) {
    return {{f(0), f(1), f(2), f(3)}};
}

inline Float4 operator+(Float4 a, Float4 b) {
    return lanes([&](int i) { return a.v[i] + b.v[i]; });
}
inline Float4 operator-(Float4 a, Float4 b) {
    return lanes([&](int i) { return a.v[i] - b.v[i]; });
}
inline Float4 operator*(Float4 a, Float4 b) {
    return lanes([&](int i) { return a.v[i] * b.v[i]; });
}
inline Float4 min(Float4 a, Float4 b) {
    return lanes([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
inline Float4 max(Float4 a, Float4 b) {
    return lanes([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
inline Float4 less(Float4 a, Float4 b) {
    return lanes([&](int i) { return std::bit_cast<float>(a.v[i] < b.v[i] ? ~0u : 0u); });
}
inline Float4 notLess(Float4 a, Float4 b) {
    return lanes([&](int i) { return std::bit_cast<float>(a.v[i] < b.v[i] ? 0u : ~0u); });
}
inline Float4 select(Float4 mask, Float4 yes, Float4 no) {
    return lanes([&](int i) { return std::bit_cast<uint32_t>(mask.v[i]) ? yes.v[i] : no.v[i]; });
}
inline Float4 orMask(Float4 a, Float4 mask) {
    return select(mask, mask, a);
}
inline bool firstLane(Float4 mask) {
    return std::bit_cast<uint32_t>(mask.v[0]) != 0;
}
template <int Lane>
Float4 splatLane(Float4 a) {
    return Float4::splat(a.v[Lane]);
}
inline void store(float* out, Float4 a) {
    for (int i = 0; i < 4; ++i) out[i] = a.v[i];
}
inline void transpose3(Float4& a, Float4& b, Float4& c) {
    std::swap(a.v[1], b.v[0]);
    std::swap(a.v[2], c.v[0]);
    std::swap(b.v[2], c.v[1]);
}

struct alignas(16) Int4 {
    int32_t v[4];

    static Int4 splat(int32_t x) { return {{x, x, x, x}}; }
};

inline Int4 operator+(Int4 a, Int4 b) {
    return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
}
inline Int4 operator-(Int4 a, Int4 b) {
    return {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2], a.v[3] - b.v[3]}};
}
inline Int4 toInt(Float4 a) {
    return {{int32_t(a.v[0]), int32_t(a.v[1]), int32_t(a.v[2]), int32_t(a.v[3])}};
}
inline Float4 toFloat(Int4 a) {
    return lanes([&](int i) { return float(a.v[i]); });
}
inline Int4 bits(Float4 a) {
    return std::bit_cast<Int4>(a);
}
inline void store(int32_t* out, Int4 a) {
    for (int i = 0; i < 4; ++i) out[i] = a.v[i];
}
inline Int4 loadInt4(const int32_t* in) {
    return {{in[0], in[1], in[2], in[3]}};
}

#endif

inline glm::vec3 toVec3(Float4 a) {
    float lanes[4];
    store(lanes, a);
    return {lanes[0], lanes[1], lanes[2]};
}

}  // namespace vitrine
