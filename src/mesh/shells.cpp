// SPDX-License-Identifier: MIT
#include "mesh/shells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>

#include "mesh/self_contact.hpp"

namespace vitrine {
namespace {

struct Edge {
    uint32_t low, high;
    uint32_t triangle;
    bool ascends;
};

/// Without a neighbour, in the direction of its triangle.
struct Rim {
    uint32_t from, to;
};

/// Triangles by the groups that edges join. A group is `broken` if an edge of it has more than two
/// triangles, or two that run along it the same way.
class Groups {
  public:
    explicit Groups(const std::vector<glm::uvec3>& triangles)
        : parents_(triangles.size()), broken_(triangles.size()), rims_(triangles.size()) {
        std::iota(parents_.begin(), parents_.end(), 0u);
        std::vector<Edge> edges;
        edges.reserve(3 * triangles.size());
        for (uint32_t t = 0; t < triangles.size(); ++t)
            for (int i = 0; i < 3; ++i) {
                const uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
                edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
            }
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
        });
        for (size_t i = 0, end = 0; i < edges.size(); i = end) {
            for (end = i + 1; end < edges.size() && edges[end].low == edges[i].low &&
                              edges[end].high == edges[i].high;)
                ++end;
            use(std::span(edges).subspan(i, end - i));
        }
        // What was noted at triangles belongs to their groups.
        for (uint32_t t = 0; t < triangles.size(); ++t) {
            const uint32_t root = find(t);
            if (root == t) continue;
            broken_[root] |= broken_[t];
            rims_[root].insert(rims_[root].end(), rims_[t].begin(), rims_[t].end());
        }
    }

    uint32_t find(uint32_t t) {
        while (parents_[t] != t) t = parents_[t] = parents_[parents_[t]];
        return t;
    }
    [[nodiscard]] bool broken(uint32_t root) const { return broken_[root] != 0; }
    [[nodiscard]] const std::vector<Rim>& rims(uint32_t root) const { return rims_[root]; }

  private:
    void use(std::span<const Edge> same) {
        const Edge& first = same[0];
        if (first.low == first.high || same.size() > 2 ||
            (same.size() == 2 && same[0].ascends == same[1].ascends))
            broken_[first.triangle] = 1;
        else if (same.size() == 1)
            rims_[first.triangle].push_back(
                {first.ascends ? first.low : first.high, first.ascends ? first.high : first.low});
        for (const Edge& edge : same) parents_[find(edge.triangle)] = find(first.triangle);
    }

    std::vector<uint32_t> parents_;
    std::vector<uint8_t> broken_;
    std::vector<std::vector<Rim>> rims_;
};

/// One triangle an edge of each rim, all of which meet in the middle of it, a new point. Nothing if
/// rims touch.
std::optional<std::vector<glm::uvec3>> closeHoles(const std::vector<Rim>& rims,
                                                  std::vector<glm::vec3>& points) {
    std::map<uint32_t, uint32_t> next;
    for (const Rim& rim : rims)
        if (!next.emplace(rim.from, rim.to).second) return std::nullopt;
    std::vector<glm::uvec3> closed;
    while (!next.empty()) {
        std::vector<uint32_t> loop;
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            if (loop.empty()) loop.push_back(at->first);
            loop.push_back(at->second);
            next.erase(at);
        }
        if (loop.front() != loop.back()) return std::nullopt;
        glm::dvec3 middle(0);
        for (size_t i = 1; i < loop.size(); ++i) middle += glm::dvec3(points[loop[i]]);
        const auto number = static_cast<uint32_t>(points.size());
        points.emplace_back(middle / static_cast<double>(loop.size() - 1));
        for (size_t i = 1; i < loop.size(); ++i) closed.emplace_back(loop[i], loop[i - 1], number);
    }
    return closed;
}

/// A closed surface whose triangles face either outwards or inwards, all of them.
struct Surface {
    std::vector<glm::uvec3> triangles;
    std::span<const glm::vec3> points;

    [[nodiscard]] std::array<glm::dvec3, 3> cornersFrom(const glm::uvec3& t,
                                                        const glm::dvec3& point) const {
        return {glm::dvec3(points[t.x]) - point, glm::dvec3(points[t.y]) - point,
                glm::dvec3(points[t.z]) - point};
    }
};

/// Do all face away from the point, with a margin for rounding, and surround it once? Then rays
/// from it meet one triangle each, so none lies before another. The solid angle is that of Van
/// Oosterom & Strackee (1983).
bool surroundsOnce(const Surface& surface, const glm::dvec3& point) {
    double angle = 0;
    for (const glm::uvec3& t : surface.triangles) {
        const auto [a, b, c] = surface.cornersFrom(t, point);
        const double volume = glm::dot(a, glm::cross(b, c));
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        if (volume <= 1e-9 * la * lb * lc) return false;
        angle += 2 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                            glm::dot(c, a) * lb);
    }
    return std::abs(angle - 4 * std::numbers::pi) < 0.01;
}

/// A connected closed surface that does not meet itself parts space in two, inside and outside, and
/// each of its triangles parts one from the other: either all fronts look outwards, or all backs
/// do. Corners at which it touches itself change nothing in that. Which it is, the volume tells.
bool partsInsideFromOutside(const Surface& surface, const Aabb& box) {
    const glm::dvec3 middle(box.centre());
    double volume = 0;
    for (const glm::uvec3& t : surface.triangles) {
        const auto [a, b, c] = surface.cornersFrom(t, middle);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    const double size = glm::length(glm::dvec3(box.extent()));
    return volume > 1e-9 * size * size * size && !meetsItself(surface.triangles, surface.points);
}

/// Numbers of vertices with those at equal positions made one.
std::vector<uint32_t> weld(const std::vector<glm::vec3>& points) {
    std::vector<uint32_t> order(points.size()), first(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](uint32_t i) {
        return std::make_tuple(points[i].x, points[i].y, points[i].z);
    };
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
    for (size_t i = 0; i < order.size(); ++i)
        first[order[i]] =
            i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
    return first;
}

}  // namespace

bool Shell::hidesBacks(const glm::vec3& eye) const {
    const glm::vec3 outside = glm::max(box.min - eye, eye - box.max);
    const float margin = 1e-3f * glm::length(box.max - box.min);
    if (std::max(outside.x, std::max(outside.y, outside.z)) <= margin) return false;
    return std::all_of(holes.begin(), holes.end(), [&](const glm::vec4& plane) {
        return glm::dot(glm::vec3(plane), eye) < plane.w - margin;
    });
}

Shells findShells(const Mesh& mesh) {
    const std::vector<uint32_t> welded = weld(mesh.positions);
    std::vector<glm::uvec3> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles)
        triangles.emplace_back(welded[t.x], welded[t.y], welded[t.z]);
    Groups groups(triangles);
    std::map<uint32_t, std::vector<uint32_t>> members;
    for (uint32_t t = 0; t < triangles.size(); ++t) members[groups.find(t)].push_back(t);

    Shells result;
    std::vector<uint32_t> rest;
    std::vector<glm::vec3> points = mesh.positions;
    for (const auto& [root, list] : members) {
        const auto caps =
            groups.broken(root) ? std::nullopt : closeHoles(groups.rims(root), points);
        Surface surface{{}, points};
        Shell shell{
            static_cast<uint32_t>(result.order.size()), static_cast<uint32_t>(list.size()), {}, {}};
        glm::dvec3 mean(0);
        for (const uint32_t t : list) {
            surface.triangles.push_back(triangles[t]);
            for (int i = 0; i < 3; ++i) {
                const glm::vec3& p = points[triangles[t][i]];
                shell.box.grow(p);
                mean += glm::dvec3(p) / (3.0 * static_cast<double>(list.size()));
            }
        }
        if (caps) surface.triangles.insert(surface.triangles.end(), caps->begin(), caps->end());
        if (!caps ||
            !(surroundsOnce(surface, glm::dvec3(shell.box.centre())) ||
              surroundsOnce(surface, mean) || partsInsideFromOutside(surface, shell.box))) {
            rest.insert(rest.end(), list.begin(), list.end());
            continue;
        }
        for (const glm::uvec3& t : *caps) {
            const glm::dvec3 from(points[t.x]);
            const auto [a, b, c] = surface.cornersFrom(t, from);
            const glm::dvec3 n = glm::normalize(glm::cross(b, c));
            shell.holes.emplace_back(n, glm::dot(n, from));
        }
        result.order.insert(result.order.end(), list.begin(), list.end());
        result.shells.push_back(std::move(shell));
    }
    result.order.insert(result.order.end(), rest.begin(), rest.end());
    return result;
}

}  // namespace vitrine
