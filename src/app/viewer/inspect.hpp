// SPDX-License-Identifier: MIT
// What lies under a pixel, read from the hit record that picking gives.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pack/pack_scene.hpp"

namespace vitrine {

/// Names and values to be read, in the order to be shown.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// Of the surface that a ray from `eye` along the unit vector `direction` (world space) has found.
/// A record that does not fit the scene, as after a reload that failed, tells as little as a miss.
Facts inspect(const PackedGeometry& geometry, const PackedMoment& moment, const glm::uvec4& record,
              const glm::vec3& eye, const glm::vec3& direction);

}  // namespace vitrine
