// SPDX-License-Identifier: MIT
// Packs rectangles into a square from the bottom left, along a skyline.
// Source: Jylänki, "A thousand ways to pack the bin", 2010, section 3.
#pragma once

#include <optional>
#include <vector>

#include "models/tank/solid.hpp"

namespace vitrine::tank {

struct PackedRectangle {
    Vec2 at;      ///< its corner of least x and y
    bool onSide;  ///< width and height have changed places
};

/// One a size, or nothing if they do not fit.
std::optional<std::vector<PackedRectangle>> packRectangles(const std::vector<Vec2>& sizes,
                                                           int side);

}  // namespace vitrine::tank
