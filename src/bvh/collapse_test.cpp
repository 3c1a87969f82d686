// SPDX-License-Identifier: MIT
#include "bvh/collapse.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"

namespace vitrine {
namespace {

using test::Random;

std::vector<Bvh> trees() {
    Random random(13);
    std::vector<Bvh> result;
    for (const int count : {1, 2, 3, 4, 5, 17, 1000, 20000})
        result.push_back(buildBvh(test::soup(random, count, 1, 0.05f).boxes(), {.maxLeafSize = 2}));
    result.push_back(buildBvh(std::vector<Aabb>(1000, Aabb{{0, 0, 0}, {1, 1, 1}})));
    return result;
}

/// The most entries a stack ever holds in a traversal that meets every box, for any choice of the
/// child to go on with: all choices are tried.
int worstStack(const std::vector<WideNode>& nodes, uint32_t node, int held) {
    const WideNode& wide = nodes[node];
    const int afterPush = held + wide.childCount - 1;
    int worst = afterPush;
    for (int i = 0; i < wide.childCount; ++i)
        if (!wide.children[i].leaf)
            worst = std::max(worst, worstStack(nodes, wide.children[i].first, afterPush));
    return worst;
}

/// A real traversal with a real stack that meets every box and goes on with the child that needs
/// the most.
int stackOfGreediestTraversal(const std::vector<WideNode>& nodes) {
    std::vector<int> need(nodes.size());
    for (size_t i = 0; i < nodes.size(); ++i) need[i] = worstStack(nodes, uint32_t(i), 0);
    std::vector<WideChild> stack{{{}, false, 0, 0}};
    size_t most = 0;
    while (!stack.empty()) {
        WideChild current = stack.back();
        stack.pop_back();
        while (!current.leaf) {
            const WideNode& node = nodes[current.first];
            std::vector<WideChild> met(node.children.begin(),
                                       node.children.begin() + node.childCount);
            const auto needOf = [&](const WideChild& c) { return c.leaf ? -1 : need[c.first]; };
            std::sort(met.begin(), met.end(), [&](const WideChild& a, const WideChild& b) {
                return needOf(a) > needOf(b);
            });
            stack.insert(stack.end(), met.begin() + 1, met.end());
            most = std::max(most, stack.size());
            current = met[0];
        }
    }
    return int(most);
}

TEST(Collapse, KeepsItemsAndBoxes) {
    for (const Bvh& bvh : trees()) {
        SCOPED_TRACE("seed 13, items " + std::to_string(bvh.items.size()));
        const auto wide = collapse4(bvh);
        std::vector<int> seen(bvh.items.size(), 0);
        std::vector<int> referenced(wide.size(), 0);
        referenced[0] = 1;
        for (size_t i = 0; i < wide.size(); ++i) {
            ASSERT_GE(wide[i].childCount, bvh.nodes.size() > 1 ? 2 : 1);
            ASSERT_LE(wide[i].childCount, kWideWidth);
            for (int c = 0; c < kWideWidth; ++c) {
                const WideChild& child = wide[i].children[c];
                if (c >= wide[i].childCount) {
                    EXPECT_TRUE(child.box.empty());
                } else if (child.leaf) {
                    for (uint32_t k = 0; k < child.count; ++k) ++seen[child.first + k];
                } else {
                    ASSERT_GT(child.first, i);
                    ++referenced[child.first];
                    Aabb content;
                    for (int k = 0; k < wide[child.first].childCount; ++k)
                        content.grow(wide[child.first].children[k].box);
                    EXPECT_EQ(content.min, child.box.min);
                    EXPECT_EQ(content.max, child.box.max);
                }
            }
        }
        EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
        EXPECT_TRUE(
            std::all_of(referenced.begin(), referenced.end(), [](int n) { return n == 1; }));
    }
}

TEST(Collapse, NodesAreWellFilled) {
    for (const Bvh& bvh : trees()) {
        if (bvh.items.size() < 1000) continue;
        const auto wide = collapse4(bvh);
        double children = 0;
        for (const WideNode& node : wide) children += node.childCount;
        EXPECT_GT(children / double(wide.size()), 2.8);
    }
}

TEST(Collapse, RaysMeetFarFewerNodes) {
    for (const Bvh& bvh : trees()) {
        if (bvh.items.size() < 1000) continue;
        // Areas of inner nodes: how many of them a ray that meets the root is expected to visit.
        double binary = 0;
        for (const BvhNode& node : bvh.nodes)
            if (!node.leaf()) binary += node.box().halfArea();
        double wide = bvh.box().halfArea();
        for (const WideNode& node : collapse4(bvh))
            for (const WideChild& child : node.children)
                if (!child.leaf) wide += child.box.halfArea();
        EXPECT_LT(wide / binary, 0.53);
    }
}

TEST(Collapse, NothingStaysNothing) {
    EXPECT_TRUE(collapse4({}).empty());
    EXPECT_EQ(wideStackBound({}), 0);
}

TEST(Collapse, StackBoundIsExact) {
    for (const Bvh& bvh : trees()) {
        SCOPED_TRACE("seed 13, items " + std::to_string(bvh.items.size()));
        const auto wide = collapse4(bvh);
        EXPECT_EQ(wideStackBound(wide), worstStack(wide, 0, 0));
        EXPECT_EQ(wideStackBound(wide), stackOfGreediestTraversal(wide));
    }
}

}  // namespace
}  // namespace vitrine
