// SPDX-License-Identifier: MIT
// The conservative ray-box test. It never misses a box that holds something the watertight
// triangle test accepts: the ray's origin is widened by the rounding of that test (Woop, Benthin,
// Wald 2013, section 4) and the distances by that of the slabs (Ize 2013, "Robust BVH Ray
// Traversal", JCGT 2(2)).
#pragma once

#include <cmath>
#include <limits>

#include "base/aabb.hpp"
#include "bvh/triangle.hpp"

namespace vitrine {

/// Of a ray's parameter t.
struct Interval {
    float min = -std::numeric_limits<float>::infinity();
    float max = std::numeric_limits<float>::infinity();

    /// Bounds at infinity come from slabs that the ray is parallel to and outside of.
    [[nodiscard]] bool empty() const {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        return !(min <= max) || min == kInfinity || max == -kInfinity;
    }
};

class SlabTest {
  public:
    /// `bounds` holds every box that will be asked for; the widening grows with its distance.
    SlabTest(const Ray& ray, const Aabb& bounds) : inverse_(1.0f / ray.direction) {
        constexpr float kEpsilon = std::numeric_limits<float>::epsilon();
        const glm::vec3 reach =
            glm::max(glm::abs(bounds.min - ray.origin), glm::abs(bounds.max - ray.origin));
        const float rounding = 4 * kEpsilon * (reach.x + reach.y + reach.z);
        for (int axis = 0; axis < 3; ++axis) {
            negative_[axis] = std::signbit(inverse_[axis]);
            const float widening = rounding + kEpsilon * std::abs(ray.origin[axis]);
            const float towards = negative_[axis] ? -widening : widening;
            nearOrigin_[axis] = ray.origin[axis] + towards;
            farOrigin_[axis] = ray.origin[axis] - towards;
        }
    }

    /// The part of the whole line in the box; a larger box never gives a smaller interval.
    [[nodiscard]] Interval operator()(const glm::vec3& min, const glm::vec3& max) const {
        constexpr float kGrow = 1 + 4 * std::numeric_limits<float>::epsilon();
        Interval result;
        for (int axis = 0; axis < 3; ++axis) {
            const float nearSide = negative_[axis] ? max[axis] : min[axis];
            const float farSide = negative_[axis] ? min[axis] : max[axis];
            const float enter = (nearSide - nearOrigin_[axis]) * inverse_[axis];
            const float leave = (farSide - farOrigin_[axis]) * inverse_[axis];
            const float early = enter > 0 ? enter / kGrow : enter * kGrow;
            const float late = leave > 0 ? leave * kGrow : leave / kGrow;
            // A direction of zero times a distance of zero is NaN: then the comparison is false and
            // the side excludes nothing.
            result.min = early > result.min ? early : result.min;
            result.max = late < result.max ? late : result.max;
        }
        return result;
    }

  private:
    glm::vec3 inverse_;
    glm::vec3 nearOrigin_;
    glm::vec3 farOrigin_;
    bool negative_[3];
};

}  // namespace vitrine
