// SPDX-License-Identifier: MIT
// What is to be seen in the window's picture.
#pragma once

#include "frame/frame.hpp"

namespace vitrine {

/// A picture that differs from the last one starts anew.
struct Wish {
    int width = 0, height = 0;
    Camera camera;
    float time = 0;
    View view = View::kColor;
    int samples = 1, bounces = 2, ssaa = 1, seed = 0;
    bool counting = false;  ///< count rays as well
    bool moving = false;  ///< more changes are coming: stay within the budget
};

void takeSettings(const RenderSettings& settings, Wish& wish);

/// As a Frame is asked for it, with its width and height times `scale` while it moves.
FrameRequest requestFor(const Wish& wish, float scale);

/// The same for few pixels, which needs the same programs: a software driver compiles others for
/// images whose width or height is a power of two.
FrameRequest smallRequestFor(const Wish& wish);

}  // namespace vitrine
