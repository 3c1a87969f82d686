// SPDX-License-Identifier: MIT
#include "bvh/level.hpp"

#include <gtest/gtest.h>

#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"

namespace vitrine {
namespace {

TEST(Level, NothingInAnEmptyTree) {
    EXPECT_TRUE(nodesOfLevel({}, 0).empty());
}

TEST(Level, EveryLevelHoldsEveryItem) {
    test::Random random(51);
    const auto mesh = test::soup(random, 3000, 1, 0.1f);
    for (const BuildMethod method :
         {BuildMethod::kNine, BuildMethod::kBinned, BuildMethod::kSpatial}) {
        const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles, {.method = method});
        const int depth = measure(bvh).depth;
        EXPECT_EQ(nodesOfLevel(bvh, 0), std::vector<uint32_t>{0});
        size_t before = 0;
        for (int level = 0; level <= depth + 2; ++level) {
            const std::vector<uint32_t> nodes = nodesOfLevel(bvh, level);
            EXPECT_LE(nodes.size(), size_t(1) << std::min(level, 40));
            EXPECT_GE(nodes.size(), before);
            before = nodes.size();
            // Side by side from left to right: the ranges of items join without gap or overlap.
            uint32_t next = 0;
            for (const uint32_t node : nodes) {
                const ItemRange items = itemsBelow(bvh, node);
                ASSERT_EQ(items.first, next);
                next += items.count;
            }
            EXPECT_EQ(next, bvh.items.size());
        }
        EXPECT_EQ(before, measure(bvh).leaves);
    }
}

TEST(Level, CountsByHand) {
    // A root with a leaf on the left and two leaves on the right.
    Bvh bvh;
    bvh.nodes = {{{0, 0, 0}, 1, {4, 1, 1}, 0},
                 {{0, 0, 0}, 0, {1, 1, 1}, 2},
                 {{1, 0, 0}, 3, {4, 1, 1}, 0},
                 {{1, 0, 0}, 2, {2, 1, 1}, 1},
                 {{3, 0, 0}, 3, {4, 1, 1}, 1}};
    bvh.items = {0, 1, 2, 3};
    EXPECT_EQ(nodesOfLevel(bvh, 1), (std::vector<uint32_t>{1, 2}));
    EXPECT_EQ(nodesOfLevel(bvh, 2), (std::vector<uint32_t>{1, 3, 4}));
    EXPECT_EQ(nodesOfLevel(bvh, 9), (std::vector<uint32_t>{1, 3, 4}));
}

}  // namespace
}  // namespace vitrine
