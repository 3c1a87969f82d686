// SPDX-License-Identifier: MIT
// Axis-aligned bounding box. The default box is empty: growing it by a point gives that point.
#pragma once

#include <limits>

#include "base/math.hpp"

namespace vitrine {

struct Aabb {
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};

    void grow(const glm::vec3& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    void grow(const Aabb& b) {
        min = glm::min(min, b.min);
        max = glm::max(max, b.max);
    }
    [[nodiscard]] bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
    [[nodiscard]] glm::vec3 extent() const { return max - min; }
    [[nodiscard]] glm::vec3 centre() const { return 0.5f * (min + max); }
    /// Half of the surface area; the surface area heuristic needs only ratios. 0 if empty.
    [[nodiscard]] float halfArea() const {
        if (empty()) return 0.0f;
        const glm::vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
    /// The box around this box's eight corners after `m` (Arvo, Graphics Gems 1990).
    [[nodiscard]] Aabb transformed(const glm::mat4& m) const {
        if (empty()) return {};
        Aabb result{glm::vec3(m[3]), glm::vec3(m[3])};
        for (int column = 0; column < 3; ++column) {
            const glm::vec3 a = glm::vec3(m[column]) * min[column];
            const glm::vec3 b = glm::vec3(m[column]) * max[column];
            result.min += glm::min(a, b);
            result.max += glm::max(a, b);
        }
        return result;
    }
};

}  // namespace vitrine
