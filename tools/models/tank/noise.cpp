// SPDX-License-Identifier: MIT
#include "models/tank/noise.hpp"

#include <cmath>
#include <cstdint>

namespace vitrine::tank {
namespace {

/// PCG3D (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3)), first word.
double hash(int32_t ix, int32_t iy, int32_t iz) {
    auto x = static_cast<uint32_t>(ix), y = static_cast<uint32_t>(iy),
         z = static_cast<uint32_t>(iz);
    x = x * 1664525u + 1013904223u;
    y = y * 1664525u + 1013904223u;
    z = z * 1664525u + 1013904223u;
    x += y * z;
    y += z * x;
    z += x * y;
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
    return double(x + y * z) / 4294967296.0;
}

}  // namespace

double noise(const Vec3& p) {
    const Vec3 cell = glm::floor(p);
    const Vec3 f = p - cell, s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    const auto x = static_cast<int32_t>(cell.x), y = static_cast<int32_t>(cell.y),
               z = static_cast<int32_t>(cell.z);
    const auto row = [&](int32_t j, int32_t k) {
        return glm::mix(hash(x, y + j, z + k), hash(x + 1, y + j, z + k), s.x);
    };
    return glm::mix(glm::mix(row(0, 0), row(1, 0), s.y), glm::mix(row(0, 1), row(1, 1), s.y), s.z);
}

double fractal(const Vec3& p, int octaves) {
    double sum = 0.0, weight = 0.0, share = 1.0;
    Vec3 q = p;
    for (int i = 0; i < octaves; ++i) {
        sum += share * noise(q);
        weight += share;
        share *= 0.5;
        // Not quite twice, and moved, so that the octaves' grids never coincide.
        q = q * 2.03 + Vec3(17.3, 9.1, 31.7);
    }
    return sum / weight;
}

}  // namespace vitrine::tank
