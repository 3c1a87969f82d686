// SPDX-License-Identifier: MIT
#include "models/tank/edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::tank {
namespace {

/// A triangle beside an edge from corner k to corner k + 1.
struct Side {
    const Triangle* triangle;
    size_t k;

    [[nodiscard]] const Corner& corner(size_t i) const { return triangle->corners[(k + i) % 3]; }
    [[nodiscard]] Vec3 flat() const {
        return glm::normalize(glm::cross(corner(1).at - corner(0).at, corner(2).at - corner(0).at));
    }
    /// No curvature at right angles to the edge.
    [[nodiscard]] bool straight() const {
        const Vec3& far = corner(2).normal;
        return std::max(glm::dot(far, corner(0).normal), glm::dot(far, corner(1).normal)) > 0.999;
    }
};

bool standsOut(const Side& a, const Side& b) {
    const double kLeast = std::cos(glm::radians(25.0));
    const Vec3 flat = a.flat();
    if (glm::dot(flat, b.flat()) > kLeast) return false;
    if (glm::dot(flat, b.corner(2).at - a.corner(0).at) > 0.0) return false;
    const bool hard = glm::dot(a.corner(0).normal, b.corner(1).normal) < 0.99;
    return hard || a.straight() || b.straight();
}

}  // namespace

OuterEdges::OuterEdges(const Solid& solid) {
    using Place = std::array<int64_t, 3>;
    const auto place = [](const Vec3& p) {
        return Place{std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6)};
    };
    std::map<std::array<Place, 2>, Side> open;
    for (const Triangle& t : solid.triangles)
        for (size_t k = 0; k < 3; ++k) {
            const Side side{&t, k};
            const Place a = place(side.corner(0).at), b = place(side.corner(1).at);
            const auto twin = open.find({b, a});
            if (twin == open.end()) {
                open.insert({{a, b}, side});
                continue;
            }
            if (standsOut(twin->second, side)) {
                grid_.add(static_cast<uint32_t>(edges_.size()), side.corner(0).at,
                          side.corner(1).at);
                edges_.push_back({side.corner(0).at, side.corner(1).at});
            }
            open.erase(twin);
        }
}

double OuterEdges::distance(const Vec3& p) const {
    double least = kReach;
    for (const uint32_t i : grid_.near(p)) {
        const auto& [a, b] = edges_[i];
        least = std::min(least, glm::distance(p, glm::mix(a, b, nearestOnSegment(p, a, b))));
    }
    return least;
}

}  // namespace vitrine::tank
