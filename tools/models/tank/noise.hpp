// SPDX-License-Identifier: MIT
// Noise in space, the same on every machine: hashed integers, no tables.
#pragma once

#include "models/tank/solid.hpp"

namespace vitrine::tank {

/// 0 to 1, 0.5 in the mean; features are one unit apart.
double noise(const Vec3& p);
/// Octaves of noise, each half as strong and twice as fine; 0 to 1.
double fractal(const Vec3& p, int octaves);

}  // namespace vitrine::tank
