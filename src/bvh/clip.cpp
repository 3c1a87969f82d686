// SPDX-License-Identifier: MIT
#include "bvh/clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

/// The box around the point in which an edge crosses the plane, not rounded to nearest.
Aabb crossing(const glm::vec3& a, const glm::vec3& b, int axis, float plane) {
    const double t = (double(plane) - double(a[axis])) / (double(b[axis]) - double(a[axis]));
    Aabb result;
    for (int i = 0; i < 3; ++i) {
        const auto nearest = float(double(a[i]) + t * (double(b[i]) - double(a[i])));
        // More than a unit in the last place; std::nextafter took a quarter of the build.
        const float slack = std::abs(nearest) * std::numeric_limits<float>::epsilon() +
                            std::numeric_limits<float>::min();
        result.min[i] = nearest - slack;
        result.max[i] = nearest + slack;
    }
    result.min[axis] = result.max[axis] = plane;
    return result;
}

Aabb common(const Aabb& a, const Aabb& b) {
    const Aabb result{glm::max(a.min, b.min), glm::min(a.max, b.max)};
    return result.empty() ? Aabb{} : result;
}

}  // namespace

ClippedBoxes clip(const Corners& triangle, const Aabb& box, int axis, float plane) {
    ClippedBoxes result;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3& a = triangle[i];
        const glm::vec3& b = triangle[(i + 1) % 3];
        if (a[axis] <= plane) result.left.grow(a);
        if (a[axis] >= plane) result.right.grow(a);
        if ((a[axis] < plane && plane < b[axis]) || (b[axis] < plane && plane < a[axis])) {
            const Aabb point = crossing(a, b, axis, plane);
            result.left.grow(point);
            result.right.grow(point);
        }
    }
    return {common(result.left, box), common(result.right, box)};
}

bool isClippable(const Corners& triangle) {
    const glm::dvec3 a(triangle[0]), b(triangle[1]), c(triangle[2]);
    const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
    const double longest = std::max(square(b - a), std::max(square(c - b), square(a - c)));
    // Height over length of about 1e-3.
    return std::sqrt(square(glm::cross(b - a, c - a))) > 1e-3 * longest;
}

}  // namespace vitrine
