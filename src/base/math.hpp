// SPDX-License-Identifier: MIT
// The one place that configures GLM. Column-major matrices, right-handed, radians.
#pragma once

#define GLM_FORCE_XYZW_ONLY
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace vitrine {

inline constexpr float kPi = 3.14159265358979323846f;

inline bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace vitrine
