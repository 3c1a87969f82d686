// SPDX-License-Identifier: MIT
// When two tracers agree about a ray and some triangles, in terms that do not depend on either.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "base/math.hpp"
#include "bvh/triangle.hpp"

namespace vitrine::test {

inline std::string textOf(const Ray& r) {
    return fmt::format("({}, {}, {}) + t ({}, {}, {})", r.origin.x, r.origin.y, r.origin.z,
                       r.direction.x, r.direction.y, r.direction.z);
}

/// What a tracer said of a ray: where, and the triangle's corners in the world.
struct Answer {
    double t;
    glm::dvec3 corners[3];
};

/// The least distance between a ray (from its origin on) and the edges of a triangle.
inline double distanceToEdges(const Ray& ray, const glm::dvec3 (&corners)[3]) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(ray.direction));
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = corners[i] - glm::dvec3(ray.origin);
        const glm::dvec3 e = corners[(i + 1) % 3] - corners[i];
        // In the plane across the ray, the least distance of the projected edge from the ray.
        const glm::dvec3 a2 = a - glm::dot(a, d) * d;
        const glm::dvec3 e2 = e - glm::dot(e, d) * d;
        const double length = glm::dot(e2, e2);
        const double s = length > 0 ? std::clamp(-glm::dot(a2, e2) / length, 0.0, 1.0) : 0;
        least = std::min(least, glm::length(a2 + s * e2));
    }
    return least;
}

/// Rounding that no float tracer can avoid: this part of the distances that a ray has to do with,
/// across the ray. Four roundings of each coordinate.
inline constexpr double kAcross = 5e-7;

inline double reachOf(const Ray& ray, const Answer& answer) {
    double reach = 0;
    for (const glm::dvec3& corner : answer.corners)
        reach =
            std::max({reach, glm::length(corner - glm::dvec3(ray.origin)), glm::length(corner)});
    return std::max(reach, glm::length(glm::dvec3(ray.origin)));
}

/// Sine of the angle between the ray and the triangle's plane.
inline double sineTo(const Ray& ray, const Answer& answer) {
    const glm::dvec3 n =
        glm::cross(answer.corners[1] - answer.corners[0], answer.corners[2] - answer.corners[0]);
    const glm::dvec3 d(ray.direction);
    return std::abs(glm::dot(n, d)) / std::max(glm::length(n) * glm::length(d), 1e-300);
}

enum class Verdict { kSame, kOnTheLimit, kWrong };

/// The same: both miss, or the distances along the ray differ by no more than the rounding across
/// it, divided by the sine at which the ray meets the triangle. On the limit: one sees a triangle
/// that the other does not, and the ray passes one of its edges, or starts on it, within the
/// rounding.
inline Verdict compare(const Ray& ray, const std::optional<Answer>& a,
                       const std::optional<Answer>& b, double across = kAcross) {
    if (!a && !b) return Verdict::kSame;
    const double unit = glm::length(glm::dvec3(ray.direction));
    if (a && b) {
        const double sine = std::max(std::min(sineTo(ray, *a), sineTo(ray, *b)), 1e-12);
        const double allowed = across * std::max(reachOf(ray, *a), reachOf(ray, *b)) / sine;
        if (std::abs(a->t - b->t) * unit <= allowed) return Verdict::kSame;
    }
    // The nearer one is what the other has overlooked.
    const Answer& nearer = !b || (a && a->t < b->t) ? *a : *b;
    const double rounding = across * reachOf(ray, nearer);
    const bool starts = std::abs(nearer.t) * unit * sineTo(ray, nearer) <= rounding;
    return starts || distanceToEdges(ray, nearer.corners) <= rounding ? Verdict::kOnTheLimit
                                                                      : Verdict::kWrong;
}

}  // namespace vitrine::test
