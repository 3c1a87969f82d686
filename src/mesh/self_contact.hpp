// SPDX-License-Identifier: MIT
// Does a surface meet itself anywhere but where its triangles are joined?
#pragma once

#include <span>

#include "base/math.hpp"

namespace vitrine {

/// True if two of the triangles have a point in common that is no common corner and not on a common
/// edge, or come so near to it that doubles cannot tell; corners are common where their numbers are
/// equal. `numbers` index `points`. Also true where an answer would take more than some hundred
/// comparisons a triangle: at surfaces of long needles in a bundle.
bool meetsItself(std::span<const glm::uvec3> numbers, std::span<const glm::vec3> points);

}  // namespace vitrine
