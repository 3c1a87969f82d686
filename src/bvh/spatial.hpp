// SPDX-License-Identifier: MIT
// The builder that may cut triangles in two at a plane. Private to the builders; see build.hpp.
#pragma once

#include <span>
#include <vector>

#include "bvh/build.hpp"
#include "bvh/split.hpp"

namespace vitrine {

/// `references`: one a triangle, not none.
Bvh buildSpatial(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                 std::vector<Reference> references, const BuildOptions& options);

}  // namespace vitrine
