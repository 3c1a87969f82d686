// SPDX-License-Identifier: MIT
// LDR-FLIP: how large the difference between two pictures looks to a person who flips between them
// on a screen. Built from the formulas of Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and
// Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph.
// Interact. Tech. 3(2), 2020 (High Performance Graphics).
#pragma once

#include "image/image.hpp"

namespace vitrine {

/// The paper's viewer: 0.7 m from a screen that is 0.7 m wide and has 3840 pixels across.
inline constexpr float kPixelsPerDegree = 67.0206f;

struct FlipResult {
    ImageMap map;       // 0: looks the same; 1: could not differ more
    double mean = 0.0;  // of the map; 0 if the pictures are empty
};

/// The order of the pictures does not matter; alpha is ignored. Equal pictures give exactly 0. The
/// more pixels a degree holds, the less is seen of fine differences. The result does not depend on
/// the number of threads. Throws InputError if the pictures differ in size.
FlipResult flip(const ImageRgba8& reference, const ImageRgba8& test,
                float pixelsPerDegree = kPixelsPerDegree);

}  // namespace vitrine
