// SPDX-License-Identifier: MIT
#include "mesh/self_contact.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "base/aabb.hpp"

namespace vitrine {
namespace {

/// Of lengths and volumes, against those that they are made of: what rounding may have done.
constexpr double kRounding = 1e-9;

using Corners = std::array<glm::dvec3, 3>;

/// A wedge of directions from a point, which is a corner of a triangle, between those of its edges.
struct Wedge {
    glm::dvec3 from, to;

    [[nodiscard]] glm::dvec3 normal() const { return glm::cross(from, to); }

    /// Of a direction in the plane of the wedge.
    [[nodiscard]] bool mayHave(const glm::dvec3& d) const {
        const glm::dvec3 n = normal();
        const double least = -kRounding * glm::length(n) * glm::length(d);
        return glm::dot(n, glm::cross(from, d)) >= least * glm::length(from) &&
               glm::dot(n, glm::cross(d, to)) >= least * glm::length(to);
    }
};

/// Do they have more in common than their point? Then the triangles do, and only then.
bool meet(const Wedge& a, const Wedge& b) {
    const glm::dvec3 n = a.normal();
    const auto height = [&](const glm::dvec3& d) {
        const double h = glm::dot(n, d);
        return std::abs(h) <= kRounding * glm::length(n) * glm::length(d) ? 0.0 : h;
    };
    const double from = height(b.from), to = height(b.to);
    if (from * to > 0) return false;
    if (from == 0 && to == 0)
        return a.mayHave(b.from) || a.mayHave(b.to) || b.mayHave(a.from) || b.mayHave(a.to);
    // Where b passes through the plane of a.
    return a.mayHave(std::abs(to) * b.from + std::abs(from) * b.to);
}

/// Of triangles with a common edge: does one lie on the other?
bool isFolded(const glm::dvec3& edge, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 na = glm::cross(edge, a), nb = glm::cross(edge, b);
    return glm::dot(na, nb) >= 0 &&
           glm::length(glm::cross(na, nb)) <= kRounding * glm::length(na) * glm::length(nb);
}

/// Of triangles without a common corner: is there no plane between them? Such a plane can always be
/// had across one of these directions (Gottschalk, Lin & Manocha 1996).
bool meet(const Corners& a, const Corners& b) {
    // From one of the corners, for the sake of what rounding does.
    const std::array<glm::dvec3, 6> p{glm::dvec3(0), a[1] - a[0], a[2] - a[0],
                                      b[0] - a[0],   b[1] - a[0], b[2] - a[0]};
    double size = 0;
    for (const glm::dvec3& each : p) size = std::max(size, glm::dot(each, each));
    size = std::sqrt(size);
    const auto parts = [&](const glm::dvec3& axis) {
        std::array<double, 6> h;
        for (size_t i = 0; i < 6; ++i) h[i] = glm::dot(axis, p[i]);
        const double gap = std::max(std::min({h[3], h[4], h[5]}) - std::max({h[0], h[1], h[2]}),
                                    std::min({h[0], h[1], h[2]}) - std::max({h[3], h[4], h[5]}));
        return gap > kRounding * size * glm::length(axis);
    };
    const std::array<glm::dvec3, 3> ea{p[1], p[2] - p[1], -p[2]},
        eb{p[4] - p[3], p[5] - p[4], p[3] - p[5]};
    const glm::dvec3 na = glm::cross(ea[0], ea[1]), nb = glm::cross(eb[0], eb[1]);
    if (parts(na) || parts(nb)) return false;
    for (const glm::dvec3& ia : ea)
        for (const glm::dvec3& ib : eb)
            if (parts(glm::cross(ia, ib))) return false;
    for (size_t i = 0; i < 3; ++i)
        if (parts(glm::cross(na, ea[i])) || parts(glm::cross(nb, eb[i]))) return false;
    return true;
}

/// A tree of boxes over the triangles, halved along the longest side again and again. Children of a
/// node lie next to each other.
class Tree {
  public:
    Tree(std::span<const glm::uvec3> numbers, std::span<const glm::vec3> points)
        : numbers_(numbers), points_(points), order_(numbers.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        boxes_.reserve(numbers.size());
        for (const glm::uvec3& t : numbers) {
            Aabb& box = boxes_.emplace_back();
            for (int i = 0; i < 3; ++i) box.grow(points[t[i]]);
        }
        nodes_.push_back({{}, 0, static_cast<uint32_t>(numbers.size()), 0});
        for (size_t i = 0; i < nodes_.size(); ++i) divide(i);
    }

    [[nodiscard]] bool meetsItself() const {
        size_t left = kComparisonsEach * numbers_.size();
        std::vector<std::pair<uint32_t, uint32_t>> pairs{{0, 0}};
        while (!pairs.empty()) {
            const auto [a, b] = pairs.back();
            pairs.pop_back();
            if (left-- == 0) return true;
            const Node &na = nodes_[a], &nb = nodes_[b];
            if (!overlap(na.box, nb.box)) continue;
            const uint32_t ca = na.children, cb = nb.children;
            if (a == b && ca != 0) {
                pairs.insert(pairs.end(), {{ca, ca}, {ca + 1, ca + 1}, {ca, ca + 1}});
            } else if (ca != 0 && (cb == 0 || na.count >= nb.count)) {
                pairs.insert(pairs.end(), {{ca, b}, {ca + 1, b}});
            } else if (cb != 0) {
                pairs.insert(pairs.end(), {{a, cb}, {a, cb + 1}});
            } else if (leavesMeet(na, nb)) {
                return true;
            }
        }
        return false;
    }

  private:
    /// Surfaces of models and of bumps take about twenty.
    static constexpr size_t kComparisonsEach = 200;
    static constexpr uint32_t kLeafSize = 3;

    struct Node {
        Aabb box;
        uint32_t first = 0, count = 0;  // in order_
        uint32_t children = 0;          // the first of the two; 0 in leaves
    };

    static bool overlap(const Aabb& a, const Aabb& b) {
        return glm::all(glm::lessThanEqual(a.min, b.max)) &&
               glm::all(glm::lessThanEqual(b.min, a.max));
    }
    void divide(size_t i) {
        Node node = nodes_[i];
        Aabb middles;
        for (uint32_t k = node.first; k < node.first + node.count; ++k) {
            const Aabb& box = boxes_[order_[k]];
            node.box.grow(box);
            middles.grow(box.min + box.max);
        }
        if (node.count > kLeafSize) {
            const glm::vec3 e = middles.max - middles.min;
            const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
            const uint32_t half = node.count / 2;
            const auto begin = order_.begin() + node.first;
            const auto key = [&](uint32_t t) { return boxes_[t].min[axis] + boxes_[t].max[axis]; };
            std::nth_element(begin, begin + half, begin + node.count,
                             [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
            node.children = static_cast<uint32_t>(nodes_.size());
            nodes_.push_back({{}, node.first, half, 0});
            nodes_.push_back({{}, node.first + half, node.count - half, 0});
        }
        nodes_[i] = node;
    }

    [[nodiscard]] bool leavesMeet(const Node& a, const Node& b) const {
        for (uint32_t i = a.first; i < a.first + a.count; ++i)
            for (uint32_t j = &a == &b ? i + 1 : b.first; j < b.first + b.count; ++j)
                if (trianglesMeet(order_[i], order_[j])) return true;
        return false;
    }

    [[nodiscard]] bool trianglesMeet(uint32_t first, uint32_t second) const {
        if (!overlap(boxes_[first], boxes_[second])) return false;
        Corners a, b;
        // Common corners come first, in both.
        std::array<int, 3> orderA{0, 1, 2}, orderB{0, 1, 2};
        size_t common = 0;
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = common; j < 3; ++j)
                if (numbers_[first][orderA[i]] == numbers_[second][orderB[j]]) {
                    std::swap(orderA[i], orderA[common]);
                    std::swap(orderB[j], orderB[common]);
                    ++common;
                    break;
                }
        for (size_t i = 0; i < 3; ++i) {
            a[i] = points_[numbers_[first][orderA[i]]];
            b[i] = points_[numbers_[second][orderB[i]]];
        }
        switch (common) {
            case 0:
                return meet(a, b);
            case 1:
                return meet(Wedge{a[1] - a[0], a[2] - a[0]}, Wedge{b[1] - b[0], b[2] - b[0]});
            case 2:
                return isFolded(a[1] - a[0], a[2] - a[0], b[2] - a[0]);
            default:
                return true;
        }
    }

    std::span<const glm::uvec3> numbers_;
    std::span<const glm::vec3> points_;
    std::vector<Aabb> boxes_;
    std::vector<uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace

bool meetsItself(std::span<const glm::uvec3> numbers, std::span<const glm::vec3> points) {
    return !numbers.empty() && Tree(numbers, points).meetsItself();
}

}  // namespace vitrine
