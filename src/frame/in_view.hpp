// SPDX-License-Identifier: MIT
// Which boxes the camera may see, and how far away they are.
#pragma once

#include "base/aabb.hpp"

namespace vitrine {

/// All corners of the box (world space) lie on the wrong side of one and the same side of the view.
/// False does not say that any of it is seen.
bool isOutside(const Aabb& box, const glm::mat4& clipFromWorld);

/// From the eye to the corner farthest from it, m.
float farthestDistance(const Aabb& box, const glm::vec3& eye);

}  // namespace vitrine
