// SPDX-License-Identifier: MIT
// Ray queries on the CPU: the oracle that the shader's tracer is compared with.
//
// A triangle counts as hit if the watertight test says so and the ray also meets the triangle's own
// box, by the same conservative test that the nodes use; t is clamped to the box. Rounding is
// monotone, so the interval of a node contains those of all triangles below it, and therefore a
// traversal finds *exactly* what brute force finds: same triangle, same t, for any tree.
// At equal t the smaller triangle number wins.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "bvh/bvh.hpp"
#include "bvh/triangle.hpp"

namespace vitrine {

struct TriangleHit {
    float t;
    float u;  ///< see TriangleIntersection
    float v;
    uint32_t triangle;
    bool operator==(const TriangleHit&) const = default;
};

struct TraversalCounters {
    uint64_t nodes = 0;  ///< boxes tested
    uint64_t triangles = 0;
};

std::optional<TriangleHit> closestHit(const Bvh& bvh, std::span<const glm::vec3> positions,
                                      std::span<const glm::uvec3> triangles, const Ray& ray,
                                      TraversalCounters* counters = nullptr);

bool anyHit(const Bvh& bvh, std::span<const glm::vec3> positions,
            std::span<const glm::uvec3> triangles, const Ray& ray,
            TraversalCounters* counters = nullptr);

/// The definition: looks at every triangle. For tests.
std::optional<TriangleHit> bruteForceClosestHit(std::span<const glm::vec3> positions,
                                                std::span<const glm::uvec3> triangles,
                                                const Ray& ray);

}  // namespace vitrine
