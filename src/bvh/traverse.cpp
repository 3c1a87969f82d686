// SPDX-License-Identifier: MIT
#include "bvh/traverse.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "bvh/slab.hpp"

namespace vitrine {
namespace {

/// One entry per level is pushed; the builder's depth is at most 63.
constexpr int kStackSize = 64;

/// One query: a ray against some triangles, with the interval in which hits still count.
class Query {
  public:
    Query(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
          const Ray& ray, const Aabb& bounds)
        : positions_(positions),
          triangles_(triangles),
          sheared_(ray),
          slabs_(ray, bounds),
          tMin_(ray.tMin),
          tMax_(ray.tMax) {}

    /// Where the line enters the box; nothing if no hit in the box can count.
    std::optional<float> enter(const BvhNode& node) const {
        const Interval box = slabs_(node.min, node.max);
        if (box.empty() || std::max(box.min, tMin_) > std::min(box.max, tMax_)) return {};
        return box.min;
    }

    void test(uint32_t triangle) {
        const glm::uvec3 corners = triangles_[triangle];
        const glm::vec3& a = positions_[corners.x];
        const glm::vec3& b = positions_[corners.y];
        const glm::vec3& c = positions_[corners.z];
        const auto hit = intersectLine(sheared_, a, b, c);
        if (!hit) return;
        const Interval box = slabs_(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)));
        if (box.empty()) return;
        const float t = std::clamp(hit->t, box.min, box.max);
        if (t < tMin_ || t > tMax_) return;
        if (closest_ && t == closest_->t && triangle > closest_->triangle) return;
        closest_ = TriangleHit{t, hit->u, hit->v, triangle};
        tMax_ = t;
    }

    [[nodiscard]] const std::optional<TriangleHit>& closest() const { return closest_; }
    [[nodiscard]] bool canCount(float t) const { return t <= tMax_; }

  private:
    std::span<const glm::vec3> positions_;
    std::span<const glm::uvec3> triangles_;
    ShearedRay sheared_;
    SlabTest slabs_;
    float tMin_;
    float tMax_;
    std::optional<TriangleHit> closest_;
};

/// Visits the nearer child first. Stops at the first hit if any hit will do.
void traverse(const Bvh& bvh, Query& query, bool stopAtFirst, TraversalCounters* counters) {
    struct Entry {
        uint32_t node;
        float enter;
    };
    std::array<Entry, kStackSize> stack;
    int size = 0;
    TraversalCounters counted;

    const auto push = [&](uint32_t node, float enter) {
        assert(size < kStackSize);
        stack[size++] = {node, enter};
    };
    ++counted.nodes;
    if (const auto enter = query.enter(bvh.nodes[0])) push(0, *enter);
    while (size > 0 && !(stopAtFirst && query.closest())) {
        const Entry entry = stack[--size];
        if (!query.canCount(entry.enter)) continue;
        const BvhNode& node = bvh.nodes[entry.node];
        if (node.leaf()) {
            for (uint32_t i = 0; i < node.count; ++i) query.test(bvh.items[node.first + i]);
            counted.triangles += node.count;
            continue;
        }
        counted.nodes += 2;
        const auto left = query.enter(bvh.nodes[node.first]);
        const auto right = query.enter(bvh.nodes[node.first + 1]);
        const bool rightFirst = left && right && *right < *left;
        if (left && rightFirst) push(node.first, *left);
        if (right) push(node.first + 1, *right);
        if (left && !rightFirst) push(node.first, *left);
    }
    if (counters) {
        counters->nodes += counted.nodes;
        counters->triangles += counted.triangles;
    }
}

}  // namespace

std::optional<TriangleHit> closestHit(const Bvh& bvh, std::span<const glm::vec3> positions,
                                      std::span<const glm::uvec3> triangles, const Ray& ray,
                                      TraversalCounters* counters) {
    if (bvh.empty()) return {};
    Query query(positions, triangles, ray, bvh.box());
    traverse(bvh, query, false, counters);
    return query.closest();
}

bool anyHit(const Bvh& bvh, std::span<const glm::vec3> positions,
            std::span<const glm::uvec3> triangles, const Ray& ray, TraversalCounters* counters) {
    if (bvh.empty()) return false;
    Query query(positions, triangles, ray, bvh.box());
    traverse(bvh, query, true, counters);
    return query.closest().has_value();
}

std::optional<TriangleHit> bruteForceClosestHit(std::span<const glm::vec3> positions,
                                                std::span<const glm::uvec3> triangles,
                                                const Ray& ray) {
    Aabb bounds;
    for (const glm::uvec3& corners : triangles)
        for (int i = 0; i < 3; ++i) bounds.grow(positions[corners[i]]);
    Query query(positions, triangles, ray, bounds);
    for (uint32_t i = 0; i < triangles.size(); ++i) query.test(i);
    return query.closest();
}

}  // namespace vitrine
