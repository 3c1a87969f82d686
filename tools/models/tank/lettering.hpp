// SPDX-License-Identifier: MIT
// Stencilled numbers.
#pragma once

#include "models/tank/marks.hpp"

namespace vitrine::tank {

/// 1 where paint went through the stencil, with an edge as soft as `softness` metres. `normal` is
/// the surface's: the back of what is painted stays clean.
double stencil(const Lettering& lettering, const Vec3& p, const Vec3& normal, double softness);

}  // namespace vitrine::tank
