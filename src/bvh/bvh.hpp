// SPDX-License-Identifier: MIT
// The binary bounding volume hierarchy: plain data. build.hpp makes it, traverse.hpp and
// collapse.hpp read it. A tree over boxes knows nothing of what is in the boxes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/aabb.hpp"

namespace vitrine {

/// Inner node (count == 0): children are nodes[first] and nodes[first + 1].
/// Leaf: holds items[first, first + count).
struct BvhNode {
    glm::vec3 min;
    uint32_t first;
    glm::vec3 max;
    uint32_t count;

    [[nodiscard]] bool leaf() const { return count != 0; }
    [[nodiscard]] Aabb box() const { return {min, max}; }
};
static_assert(sizeof(BvhNode) == 32);

struct Bvh {
    std::vector<BvhNode> nodes;  ///< nodes[0] is the root; parents come before children
    /// Each index of the built boxes exactly once, or at least once after spatial splits. Then the
    /// boxes of the leaves of an item cover it together.
    std::vector<uint32_t> items;

    [[nodiscard]] bool empty() const { return nodes.empty(); }
    [[nodiscard]] Aabb box() const { return empty() ? Aabb{} : nodes[0].box(); }
};

struct BvhStatistics {
    /// Expected cost of a random ray that hits the root box (MacDonald & Booth 1990).
    double sahCost = 0;
    size_t nodes = 0;
    size_t references = 0;  ///< items of all leaves; more than there are items after spatial splits
    size_t leaves = 0;
    int depth = 0;  ///< edges from the root to the deepest leaf
    int maxLeaf = 0;
    double meanLeaf = 0;
    std::array<size_t, 9> leafSizes{};  ///< leaves by item count; the last one counts 8 and more
};

BvhStatistics measure(const Bvh& bvh, float traversalCost = 1, float intersectionCost = 1);

}  // namespace vitrine
