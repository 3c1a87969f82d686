// SPDX-License-Identifier: MIT
#include "bvh/build.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "bvh/test_meshes.hpp"
#include "bvh/test_trees.hpp"

namespace vitrine {
namespace {

using test::expectValid;
using test::Random;
using test::sameBytes;

/// The SAH cost, times the root's area, of the best tree by greedy full sweep: every cut along
/// every axis is looked at. Simple and slow.
double fullSweepCost(const std::vector<Aabb>& boxes, std::span<uint32_t> items,
                     const BuildOptions& options) {
    Aabb all;
    for (const uint32_t item : items) all.grow(boxes[item]);
    const double area = all.halfArea();
    const double leafCost = options.intersectionCost * area * double(items.size());
    if (items.size() == 1) return leafCost;

    const auto sortAlong = [&](int axis) {
        std::sort(items.begin(), items.end(), [&](uint32_t a, uint32_t b) {
            const float ca = boxes[a].centre()[axis];
            const float cb = boxes[b].centre()[axis];
            return ca != cb ? ca < cb : a < b;
        });
    };
    double best = std::numeric_limits<double>::infinity();
    int bestAxis = 0;
    size_t bestSplit = 0;
    std::vector<double> leftAreas(items.size());
    for (int axis = 0; axis < 3; ++axis) {
        sortAlong(axis);
        Aabb side;
        for (size_t i = 0; i + 1 < items.size(); ++i) {
            side.grow(boxes[items[i]]);
            leftAreas[i + 1] = side.halfArea();
        }
        side = {};
        for (size_t i = items.size() - 1; i > 0; --i) {
            side.grow(boxes[items[i]]);
            const double cost =
                leftAreas[i] * double(i) + side.halfArea() * double(items.size() - i);
            if (cost >= best) continue;
            best = cost;
            bestAxis = axis;
            bestSplit = i;
        }
    }
    const double splitCost = options.traversalCost * area + options.intersectionCost * best;
    if (items.size() <= size_t(options.maxLeafSize) && leafCost <= splitCost) return leafCost;
    sortAlong(bestAxis);
    return options.traversalCost * area + fullSweepCost(boxes, items.first(bestSplit), options) +
           fullSweepCost(boxes, items.subspan(bestSplit), options);
}

TEST(Build, NothingAndAlmostNothing) {
    EXPECT_TRUE(buildBvh({}).empty());
    const std::vector<Aabb> boxes{{{0, 0, 0}, {1, 1, 1}}, {{5, 0, 0}, {6, 0, 0}}};
    for (size_t count = 1; count <= 2; ++count) {
        const std::vector<Aabb> some(boxes.begin(), boxes.begin() + count);
        const Bvh bvh = buildBvh(some);
        expectValid(bvh, some);
        EXPECT_EQ(bvh.nodes.size(), 2 * count - 1);
    }
}

TEST(Build, EverySizeIsATree) {
    Random random(11);
    for (int count = 1; count < 300; ++count) {
        SCOPED_TRACE("seed 11, items " + std::to_string(count));
        const auto boxes = test::soup(random, count, 1, random.uniform(0, 0.3f)).boxes();
        expectValid(buildBvh(boxes), boxes);
        expectValid(buildBvh(boxes, {.maxLeafSize = 1, .bins = 2}), boxes);
    }
}

TEST(Build, LoneItemsAreLeavesOfLargeRanges) {
    // Far from thousands of others, on either side: a task whose subtree has no nodes of its own.
    Random random(12);
    for (const float side : {-1.0f, 1.0f}) {
        auto boxes = test::soup(random, 5000, 1, 0.02f).boxes();
        for (int i = 1; i < 12; ++i) {
            const glm::vec3 at(side * std::pow(1e3f, float(i)));
            boxes.push_back({at, at + glm::vec3(std::abs(at.x) * 0.01f)});
        }
        expectValid(buildBvh(boxes), boxes);
    }
}

TEST(Build, HostileScenesAreTrees) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        for (const float scale : {1e-6f, 1.0f, 1e6f, 1e18f, 4e37f, 1e-38f}) {
            const auto boxes = test::hostileSoup(random, 500, scale).boxes();
            const Bvh bvh = buildBvh(boxes);
            expectValid(bvh, boxes);
            EXPECT_LE(measure(bvh).maxLeaf, 4);
        }
    }
}

TEST(Build, TrianglesAndTheirBoxesGiveTheSameTree) {
    Random random(3);
    const auto mesh = test::soup(random, 20000, 1, 0.02f);
    const auto boxes = mesh.boxes();
    EXPECT_TRUE(sameBytes(buildTriangleBvh(mesh.positions, mesh.triangles), buildBvh(boxes)));
}

TEST(Build, ThreadsDoNotChangeAByte) {
    // Zeros of both signs: which of them a minimum returns depends on the order of its arguments.
    Random random(5);
    auto boxes = test::soup(random, 150000, 1, 0.01f).boxes();
    for (size_t i = 0; i < boxes.size(); i += 3)
        boxes[i].min.x = boxes[i].max.x = i % 2 ? 0.f : -0.f;
    const auto buildWith = [&](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return buildBvh(boxes);
    };
    const Bvh one = buildWith(1);
    expectValid(one, boxes);
    for (const size_t threads : {2, 2, 3, 4}) EXPECT_TRUE(sameBytes(one, buildWith(threads)));
}

TEST(Build, EqualBoxesHalve) {
    const std::vector<Aabb> boxes(100000, Aabb{{1, 2, 3}, {2, 3, 4}});
    const Bvh bvh = buildBvh(boxes);
    expectValid(bvh, boxes);
    EXPECT_LE(measure(bvh).depth, 17);
    EXPECT_LE(measure(bvh).maxLeaf, 4);
}

TEST(Build, DepthIsBounded) {
    // Each box is 1.1 times as far away and as large as the one before: cuts peel off a few.
    std::vector<Aabb> boxes;
    for (int i = 0; i < 900; ++i) {
        const float size = std::pow(1.1f, float(i - 500));
        boxes.push_back({glm::vec3(size), glm::vec3(1.05f * size)});
    }
    std::shuffle(boxes.begin(), boxes.end(), std::mt19937(14));
    const BvhStatistics free = measure(buildBvh(boxes, {.maxLeafSize = 1}));
    EXPECT_GT(free.depth, 20) << "no longer adversarial";
    for (const int limit : {0, 5, 10, 11, 13, 16, 20}) {
        const Bvh bvh = buildBvh(boxes, {.maxLeafSize = 1, .maxDepth = limit});
        expectValid(bvh, boxes);
        const BvhStatistics limited = measure(bvh);
        EXPECT_LE(limited.depth, std::max(limit, 10)) << "limit " << limit;
        EXPECT_LE(limited.sahCost, 4 * free.sahCost) << "limit " << limit;
    }
}

TEST(Build, CostIsNearFullSweep) {
    struct Case {
        const char* name;
        std::vector<Aabb> boxes;
    };
    Random random(17);
    std::vector<Aabb> stadium = test::sphere(50, 60, 0.2f, {30, 1, 2}).boxes();
    for (const Aabb& box : test::soup(random, 2000, 100, 4).boxes()) stadium.push_back(box);
    const Case cases[] = {
        {"teapot in a stadium", stadium},
        {"sphere", test::sphere(80, 100, 1, {}).boxes()},
        {"small triangles", test::soup(random, 8000, 1, 0.02f).boxes()},
        {"large triangles", test::soup(random, 3000, 1, 0.4f).boxes()},
        {"equal numbers", test::hostileSoup(random, 3000, 1).boxes()},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(std::string("seed 17, ") + c.name);
        for (const float intersectionCost : {1.0f, 2.0f}) {
            BuildOptions options;
            options.intersectionCost = intersectionCost;
            std::vector<uint32_t> items(c.boxes.size());
            std::iota(items.begin(), items.end(), 0u);
            const Bvh bvh = buildBvh(c.boxes, options);
            const double sweep =
                fullSweepCost(c.boxes, items, options) / double(bvh.box().halfArea());
            const double ratio = measure(bvh, 1, intersectionCost).sahCost / sweep;
            EXPECT_LE(ratio, 1.025);
        }
    }
}

TEST(Measure, CountsByHand) {
    // Two unit cubes side by side, in a root of 2 x 1 x 1 (half area 5), each of half area 3.
    Bvh bvh;
    bvh.nodes = {
        {{0, 0, 0}, 1, {2, 1, 1}, 0}, {{0, 0, 0}, 0, {1, 1, 1}, 3}, {{1, 0, 0}, 3, {2, 1, 1}, 1}};
    bvh.items = {0, 1, 2, 3};
    const BvhStatistics s = measure(bvh, 2, 10);
    EXPECT_DOUBLE_EQ(s.sahCost, 2 + 10 * (3.0 / 5 * 3 + 3.0 / 5 * 1));
    EXPECT_EQ(s.nodes, 3u);
    EXPECT_EQ(s.leaves, 2u);
    EXPECT_EQ(s.depth, 1);
    EXPECT_EQ(s.maxLeaf, 3);
    EXPECT_DOUBLE_EQ(s.meanLeaf, 2);
    EXPECT_EQ(s.leafSizes[3], 1u);
    EXPECT_EQ(s.leafSizes[1], 1u);
}

}  // namespace
}  // namespace vitrine
