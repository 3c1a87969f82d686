// SPDX-License-Identifier: MIT
// Boxes of the two parts of a triangle that a plane across an axis cuts. Private to the builders.
#pragma once

#include <array>

#include "base/aabb.hpp"

namespace vitrine {

using Corners = std::array<glm::vec3, 3>;

struct ClippedBoxes {
    Aabb left;   ///< of the part not above the plane; empty if there is none in the box
    Aabb right;  ///< of the part not below it
};

/// The boxes of what lies in `box` of the triangle. They are rounded outwards: the parts of the
/// exact triangle are inside, and both boxes reach the plane if the triangle crosses it.
ClippedBoxes clip(const Corners& triangle, const Aabb& box, int axis, float plane);

/// Whether the parts of a triangle may stand for the whole. The point at which a ray is found to
/// hit a sliver may be anywhere along it, so that a part of one would promise too much.
bool isClippable(const Corners& triangle);

}  // namespace vitrine
