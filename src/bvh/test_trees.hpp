// SPDX-License-Identifier: MIT
// For the tests of this folder: what makes a tree valid, for builders that cut items and that do
// not.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "bvh/build.hpp"

namespace vitrine::test {

inline bool within(const Aabb& inner, const Aabb& outer) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.min[axis] < outer.min[axis] || inner.max[axis] > outer.max[axis]) return false;
    return true;
}

/// How often each item is in a leaf. Fails if the nodes are no tree.
inline std::vector<int> countItems(const Bvh& bvh, size_t items) {
    std::vector<int> itemSeen(items, 0);
    std::vector<int> nodeSeen(bvh.nodes.size(), 0);
    if (!bvh.empty()) nodeSeen[0] = 1;
    for (size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        if (node.leaf()) {
            EXPECT_LE(size_t(node.first) + node.count, bvh.items.size());
            for (uint32_t k = 0; k < node.count; ++k) ++itemSeen.at(bvh.items[node.first + k]);
        } else {
            EXPECT_GT(node.first, i);
            for (uint32_t child : {node.first, node.first + 1}) {
                ++nodeSeen.at(child);
                EXPECT_TRUE(within(bvh.nodes[child].box(), node.box())) << "node " << child;
            }
        }
    }
    EXPECT_TRUE(std::all_of(nodeSeen.begin(), nodeSeen.end(), [](int n) { return n == 1; }));
    return itemSeen;
}

/// Everything that makes it a tree over boxes that are not cut.
inline void expectValid(const Bvh& bvh, const std::vector<Aabb>& boxes) {
    ASSERT_EQ(bvh.items.size(), boxes.size());
    for (const int count : countItems(bvh, boxes.size())) ASSERT_EQ(count, 1);
    for (size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        Aabb content;
        if (!node.leaf())
            for (uint32_t child : {node.first, node.first + 1})
                content.grow(bvh.nodes[child].box());
        for (uint32_t k = 0; k < node.count; ++k) content.grow(boxes[bvh.items[node.first + k]]);
        EXPECT_TRUE(within(content, node.box()) && within(node.box(), content)) << "node " << i;
    }
}

inline bool sameBytes(const Bvh& a, const Bvh& b) {
    return a.nodes.size() == b.nodes.size() && a.items == b.items &&
           std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(BvhNode)) == 0;
}

}  // namespace vitrine::test
