// SPDX-License-Identifier: MIT
#include "app/viewer/pace.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {

void Pace::took(double seconds, double budget) {
    const double ratio = budget / std::max(seconds, 1e-5);
    // Up slowly and down at once: a late picture is worse than a coarse one. A band in which
    // nothing changes keeps the resolution from breathing.
    if (ratio > 0.87 && ratio < 1.4) return;
    const double step = std::sqrt(std::clamp(ratio, 0.05, 1.6));
    scale_ = std::clamp(scale_ * static_cast<float>(0.97 * step), kCoarsest, 1.0f);
}

}  // namespace vitrine
