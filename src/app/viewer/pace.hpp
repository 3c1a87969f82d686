// SPDX-License-Identifier: MIT
// How finely to draw while a picture moves, so that it keeps moving.
#pragma once

#include <algorithm>

namespace vitrine {

/// Adapts the resolution of a moving picture to a budget of time. Costs are taken to grow with the
/// number of pixels, plus a part that does not.
class Pace {
  public:
    static constexpr float kCoarsest = 1.0f / 12;

    /// The share of the window's width and height to draw, kCoarsest to 1.
    [[nodiscard]] float scale() const { return scale_; }
    /// A frame at the present scale took so long; `budget` is what it may take. Both seconds.
    void took(double seconds, double budget);
    /// Another scene is to be drawn, which may cost more than the last.
    void takeCareOfNews() { scale_ = std::min(scale_, kFirst); }

  private:
    static constexpr float kFirst = 0.25f;
    float scale_ = kFirst;
};

}  // namespace vitrine
