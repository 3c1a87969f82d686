// SPDX-License-Identifier: MIT
// Colours for numbers: error maps of `vitrine compare`, and counts such as steps and visited nodes.
#pragma once

#include "base/math.hpp"
#include "image/image.hpp"

namespace vitrine {

/// sRGB colour in 0..1 for `t`, which is clamped to 0..1. Dark means little: black, purple, orange,
/// pale yellow. Lightness grows evenly, so it survives a grey print and colour blindness.
glm::vec3 magma(float t);

/// The same from blue over cyan, green and yellow to red: neighbours are easier to tell apart,
/// distances are not to scale. For counts.
glm::vec3 heat(float t);

/// Each number of `map` (0 to 1) as an opaque colour; what is not a number is pure magenta, a
/// colour of neither scale.
ImageRgba8 colorize(const ImageMap& map, glm::vec3 (*scale)(float) = magma);

}  // namespace vitrine
