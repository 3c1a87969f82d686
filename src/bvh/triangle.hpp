// SPDX-License-Identifier: MIT
// Watertight ray-triangle intersection (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle
// Intersection", JCGT 2(1)): a ray through a shared edge or corner hits at least one of the
// triangles around it. Two-sided.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/math.hpp"

namespace vitrine {

/// Direction need not be normalised, must be finite and not zero. Hits have tMin <= t <= tMax.
struct Ray {
    glm::vec3 origin;
    glm::vec3 direction;
    float tMin = 0;
    float tMax = std::numeric_limits<float>::infinity();
};

/// The point hit is (1 - u - v) * v0 + u * v1 + v * v2.
struct TriangleIntersection {
    float t;
    float u;
    float v;
};

/// What the test needs of a ray: the shear that turns it into the +z axis of a space with the
/// axes permuted such that z is the one of largest direction.
struct ShearedRay {
    glm::vec3 origin;
    glm::vec3 shear;
    int kx, ky, kz;

    explicit ShearedRay(const Ray& ray) : origin(ray.origin) {
        const glm::vec3 a = glm::abs(ray.direction);
        kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
        kx = (kz + 1) % 3;
        ky = (kx + 1) % 3;
        // Keeps the winding, and so the sign of the edge functions, as in the paper.
        if (ray.direction[kz] < 0) std::swap(kx, ky);
        const float z = ray.direction[kz];
        shear = {ray.direction[kx] / z, ray.direction[ky] / z, 1.0f / z};
    }
};

/// The intersection with the whole line: the caller compares t with its interval.
inline std::optional<TriangleIntersection> intersectLine(const ShearedRay& ray, const glm::vec3& v0,
                                                         const glm::vec3& v1, const glm::vec3& v2) {
    const auto toRaySpace = [&ray](const glm::vec3& vertex) {
        const glm::vec3 p = vertex - ray.origin;
        const float z = p[ray.kz];
        return glm::vec3(p[ray.kx] - ray.shear.x * z, p[ray.ky] - ray.shear.y * z, ray.shear.z * z);
    };
    const glm::vec3 a = toRaySpace(v0);
    const glm::vec3 b = toRaySpace(v1);
    const glm::vec3 c = toRaySpace(v2);

    float edge0 = c.x * b.y - c.y * b.x;
    float edge1 = a.x * c.y - a.y * c.x;
    float edge2 = b.x * a.y - b.y * a.x;
    // A float edge function of zero may be a product that cancelled; in double its sign is exact.
    if (edge0 == 0 || edge1 == 0 || edge2 == 0) {
        const auto cross = [](const glm::vec3& p, const glm::vec3& q) {
            return float(double(p.x) * double(q.y) - double(p.y) * double(q.x));
        };
        edge0 = cross(c, b);
        edge1 = cross(a, c);
        edge2 = cross(b, a);
    }
    const bool anyNegative = edge0 < 0 || edge1 < 0 || edge2 < 0;
    const bool anyPositive = edge0 > 0 || edge1 > 0 || edge2 > 0;
    if (anyNegative && anyPositive) return {};
    const float determinant = edge0 + edge1 + edge2;
    if (determinant == 0) return {};

    const float t = (edge0 * a.z + edge1 * b.z + edge2 * c.z) / determinant;
    if (!std::isfinite(t)) return {};
    return TriangleIntersection{t, edge1 / determinant, edge2 / determinant};
}

}  // namespace vitrine
