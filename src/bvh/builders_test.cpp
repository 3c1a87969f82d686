// SPDX-License-Identifier: MIT
// The three builders against brute force, against each other, and against what they promise.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"
#include "bvh/test_trees.hpp"
#include "bvh/traverse.hpp"

namespace vitrine {
namespace {

using test::Mesh;
using test::Random;

constexpr std::array kMethods{BuildMethod::kNine, BuildMethod::kBinned, BuildMethod::kSpatial};

const char* nameOf(BuildMethod method) {
    return std::array{"nine", "binned", "spatial"}[size_t(method)];
}

Bvh build(const Mesh& mesh, BuildMethod method, int maxLeafSize = 4) {
    return buildTriangleBvh(mesh.positions, mesh.triangles,
                            {.method = method, .maxLeafSize = maxLeafSize});
}

/// Long thin triangles criss-cross.
Mesh beams(Random& random, int count, float radius) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = random.point(radius), b = random.point(radius);
        mesh.add(a, b, a + random.point(0.03f * radius));
    }
    return mesh;
}

struct Case {
    const char* name;
    Mesh mesh;
    float reach;  ///< of the rays
};

std::vector<Case> friendlyCases() {
    Random random(71);
    return {{"one triangle", test::soup(random, 1, 1, 1), 1.5f},
            {"small triangles", test::soup(random, 3000, 1, 0.05f), 1.5f},
            {"large triangles", test::soup(random, 400, 1, 0.8f), 1.5f},
            {"beams", beams(random, 500, 1), 1.5f},
            {"sphere", test::sphere(40, 60, 1, {}), 1.5f},
            {"huge", test::soup(random, 500, 1e6f, 2e5f), 1.5e6f},
            {"tiny", test::soup(random, 500, 1e-6f, 2e-7f), 1.5e-6f}};
}

TEST(Builders, GiveWhatBruteForceGives) {
    for (const Case& c : friendlyCases()) {
        for (const BuildMethod method : kMethods) {
            SCOPED_TRACE(std::string(c.name) + ", " + nameOf(method) + ", seed 72");
            const Bvh bvh = build(c.mesh, method);
            Random random(72);
            int hits = 0;
            for (int i = 0; i < 1500; ++i) {
                Ray ray = test::ray(random, c.reach);
                if (i % 3 == 0) ray.tMax = random.uniform(0, 1);
                const auto expected = bruteForceClosestHit(c.mesh.positions, c.mesh.triangles, ray);
                ASSERT_EQ(closestHit(bvh, c.mesh.positions, c.mesh.triangles, ray), expected) << i;
                ASSERT_EQ(anyHit(bvh, c.mesh.positions, c.mesh.triangles, ray),
                          expected.has_value());
                hits += expected.has_value();
            }
            if (c.mesh.triangles.size() > 100) {
                EXPECT_GT(hits, 50);
            }
        }
    }
}

TEST(Builders, GiveWhatBruteForceGivesOnHostileTriangles) {
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e6f}) {
        for (uint32_t seed = 0; seed < 4; ++seed) {
            for (const BuildMethod method : kMethods) {
                SCOPED_TRACE("seed " + std::to_string(seed) + ", scale " + std::to_string(scale) +
                             ", " + nameOf(method));
                Random random(seed);
                const Mesh mesh = test::hostileSoup(random, 250, scale);
                const Bvh bvh = build(mesh, method, random.integer(1, 8));
                for (int i = 0; i < 1000; ++i) {
                    const Ray ray =
                        i % 2 == 0 ? test::ray(random, 5 * scale) : test::axisRay(random, scale);
                    const auto expected = bruteForceClosestHit(mesh.positions, mesh.triangles, ray);
                    ASSERT_EQ(closestHit(bvh, mesh.positions, mesh.triangles, ray), expected) << i;
                }
            }
        }
    }
}

TEST(Builders, SpatialTreesDoNotLeak) {
    // A ray into a closed mesh through corners, edges and planes of cuts never comes out unseen.
    Random random(73);
    const Mesh mesh = test::sphere(24, 30, 1, {0.3f, 0.2f, -0.1f});
    const Bvh bvh = buildTriangleBvh(
        mesh.positions, mesh.triangles,
        {.method = BuildMethod::kSpatial, .maxLeafSize = 1, .maxDuplicates = 4, .minOverlap = 0});
    EXPECT_GT(bvh.items.size(), mesh.triangles.size()) << "nothing was cut";
    const glm::vec3 centre(0.3f, 0.2f, -0.1f);
    for (int i = 0; i < 30000; ++i) {
        const glm::uvec3 t = mesh.triangles[random.integer(0, int(mesh.triangles.size()) - 1)];
        const glm::vec3& a = mesh.positions[t.x];
        const glm::vec3 target =
            i % 3 == 0 ? a : glm::mix(a, mesh.positions[t.y], random.uniform(0, 1));
        const glm::vec3 origin = centre + random.point(0.3f);
        ASSERT_TRUE(anyHit(bvh, mesh.positions, mesh.triangles, {origin, target - origin}))
            << "seed 73, ray " << i;
    }
}

TEST(Builders, UncutTreesHoldEveryItemOnce) {
    for (const Case& c : friendlyCases())
        for (const BuildMethod method : {BuildMethod::kNine, BuildMethod::kBinned}) {
            SCOPED_TRACE(std::string(c.name) + ", " + nameOf(method));
            test::expectValid(build(c.mesh, method), c.mesh.boxes());
        }
    Random random(74);
    for (const float scale : {1e-6f, 1.0f, 1e6f, 1e18f, 4e37f, 1e-38f}) {
        const auto boxes = test::hostileSoup(random, 500, scale).boxes();
        test::expectValid(buildBvh(boxes, {.method = BuildMethod::kNine}), boxes);
    }
}

/// Every point of every triangle is in the box of a leaf that names the triangle.
void expectCovered(const Mesh& mesh, const Bvh& bvh) {
    std::vector<std::vector<Aabb>> boxes(mesh.triangles.size());
    for (const BvhNode& node : bvh.nodes)
        for (uint32_t k = 0; k < node.count; ++k)
            boxes[bvh.items[node.first + k]].push_back(node.box());
    Random random(75);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 40; ++i) {
            glm::vec2 w(random.uniform(0, 1), random.uniform(0, 1));
            if (w.x + w.y > 1) w = glm::vec2(1) - w;
            glm::dvec3 p(0);
            double size = 0;
            const double weights[] = {1 - double(w.x) - double(w.y), w.x, w.y};
            for (int corner = 0; corner < 3; ++corner) {
                const glm::dvec3 v(mesh.positions[mesh.triangles[t][corner]]);
                p += weights[corner] * v;
                size = std::max(size, glm::length(v));
            }
            const bool covered = std::any_of(boxes[t].begin(), boxes[t].end(), [&](const Aabb& b) {
                for (int a = 0; a < 3; ++a)
                    if (p[a] < double(b.min[a]) - 1e-14 * size ||
                        p[a] > double(b.max[a]) + 1e-14 * size)
                        return false;
                return true;
            });
            ASSERT_TRUE(covered) << "seed 75, triangle " << t;
        }
    }
}

TEST(Builders, SpatialLeavesCoverEveryTriangle) {
    std::vector<Case> cases = friendlyCases();
    Random random(76);
    for (const float scale : {1e-6f, 1.0f, 1e6f, 1e18f, 4e37f, 1e-38f})
        cases.push_back({"hostile", test::hostileSoup(random, 500, scale), 0});
    for (const Case& c : cases) {
        for (const float duplicates : {0.0f, 0.1f, 1.0f, 3.0f}) {
            SCOPED_TRACE(std::string(c.name) + ", duplicates " + std::to_string(duplicates));
            const Bvh bvh = buildTriangleBvh(
                c.mesh.positions, c.mesh.triangles,
                {.method = BuildMethod::kSpatial, .maxDuplicates = duplicates, .minOverlap = 0});
            const size_t count = c.mesh.triangles.size();
            for (const int seen : test::countItems(bvh, count)) ASSERT_GE(seen, 1);
            EXPECT_LE(double(bvh.items.size()), (1 + double(duplicates)) * double(count));
            EXPECT_LE(measure(bvh).maxLeaf, 4);
            expectCovered(c.mesh, bvh);
        }
    }
}

TEST(Builders, SpatialPaysForLargeTrianglesAmongSmallOnes) {
    Random random(77);
    Mesh mesh = test::soup(random, 5000, 1, 0.02f);
    for (int i = 0; i < 60; ++i) mesh.add(random.point(1), random.point(1), random.point(1));
    const Bvh plain = build(mesh, BuildMethod::kBinned);
    const Bvh cut = build(mesh, BuildMethod::kSpatial);
    EXPECT_LT(measure(cut).sahCost, 0.7 * measure(plain).sahCost);
    TraversalCounters plainCount, cutCount;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = test::ray(random, 1.5f);
        closestHit(plain, mesh.positions, mesh.triangles, ray, &plainCount);
        closestHit(cut, mesh.positions, mesh.triangles, ray, &cutCount);
    }
    EXPECT_LT(double(cutCount.nodes + cutCount.triangles),
              0.6 * double(plainCount.nodes + plainCount.triangles));
}

TEST(Builders, SpatialWithoutDuplicatesIsAnItemTree) {
    Random random(78);
    const Mesh mesh = beams(random, 1000, 1);
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles,
                                     {.method = BuildMethod::kSpatial, .maxDuplicates = 0});
    test::expectValid(bvh, mesh.boxes());
    EXPECT_LT(measure(bvh).sahCost, 1.02 * measure(build(mesh, BuildMethod::kBinned)).sahCost);
}

/// Area times items of both sides of every one of the nine cuts; the least. Slow, and written from
/// the definition.
double leastOfNine(const std::vector<Aabb>& boxes, std::vector<uint32_t> items) {
    Aabb all, centres;
    for (const uint32_t i : items) {
        all.grow(boxes[i]);
        centres.grow(boxes[i].min + boxes[i].max);
    }
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const auto& isLeft) {
        Aabb left, right;
        double l = 0, r = 0;
        for (size_t k = 0; k < items.size(); ++k) {
            const bool goesLeft = isLeft(k);
            (goesLeft ? left : right).grow(boxes[items[k]]);
            (goesLeft ? l : r) += 1;
        }
        if (l > 0 && r > 0)
            least = std::min(least, l * double(left.halfArea()) + r * double(right.halfArea()));
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto centre = [&](size_t k) {
            return boxes[items[k]].min[axis] + boxes[items[k]].max[axis];
        };
        std::sort(items.begin(), items.end(), [&](uint32_t a, uint32_t b) {
            const float ca = boxes[a].min[axis] + boxes[a].max[axis];
            const float cb = boxes[b].min[axis] + boxes[b].max[axis];
            return ca != cb ? ca < cb : a < b;
        });
        offer([&](size_t k) { return centre(k) < all.min[axis] + all.max[axis]; });
        offer([&](size_t k) { return k < items.size() / 2; });
        for (int plane = 1; plane < 32; ++plane)
            offer([&](size_t k) {
                const float scale = 32.0f / (centres.max[axis] - centres.min[axis]);
                return (centre(k) - centres.min[axis]) * scale < float(plane);
            });
    }
    return least;
}

void collect(const Bvh& bvh, uint32_t node, std::vector<uint32_t>& out) {
    const BvhNode& n = bvh.nodes[node];
    if (n.leaf()) {
        out.insert(out.end(), bvh.items.begin() + n.first, bvh.items.begin() + n.first + n.count);
        return;
    }
    collect(bvh, n.first, out);
    collect(bvh, n.first + 1, out);
}

TEST(Builders, NineTakesTheBestOfNine) {
    Random random(79);
    Mesh clusters;  // at sizes apart, so that middle, median and bins each win somewhere
    for (const float size : {1.0f, 0.05f, 0.002f})
        for (const auto& m : {test::soup(random, 400, size, 0.1f * size)})
            for (const glm::uvec3& t : m.triangles)
                clusters.add(m.positions[t.x], m.positions[t.y], m.positions[t.z]);
    for (const Mesh& mesh : {clusters, test::soup(random, 1500, 1, 0.3f)}) {
        const auto boxes = mesh.boxes();
        const Bvh bvh = build(mesh, BuildMethod::kNine, 1);
        int inner = 0;
        for (uint32_t i = 0; i < bvh.nodes.size(); ++i) {
            if (bvh.nodes[i].leaf()) continue;
            std::vector<uint32_t> left, right, all;
            collect(bvh, bvh.nodes[i].first, left);
            collect(bvh, bvh.nodes[i].first + 1, right);
            collect(bvh, i, all);
            const double taken =
                double(left.size()) * double(bvh.nodes[bvh.nodes[i].first].box().halfArea()) +
                double(right.size()) * double(bvh.nodes[bvh.nodes[i].first + 1].box().halfArea());
            ASSERT_LE(taken, leastOfNine(boxes, all) * (1 + 1e-5)) << "seed 79, node " << i;
            ++inner;
        }
        EXPECT_GT(inner, 500);
    }
}

TEST(Builders, NineGoesDownToOneTriangleALeaf) {
    Random random(80);
    const Mesh mesh = test::soup(random, 1000, 1, 0.1f);
    for (const BuildMethod method : kMethods) {
        const BvhStatistics s = measure(build(mesh, method, 1));
        EXPECT_EQ(s.maxLeaf, 1) << nameOf(method);
        EXPECT_EQ(s.leafSizes[1], s.leaves);
        EXPECT_EQ(s.nodes, 2 * s.leaves - 1);
    }
}

TEST(Builders, ThreadsDoNotChangeAByte) {
    Random random(81);
    const Mesh mesh = test::soup(random, 20000, 1, 0.05f);
    for (const BuildMethod method : kMethods) {
        const auto buildWith = [&](size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            return build(mesh, method);
        };
        const Bvh one = buildWith(1);
        for (const size_t threads : {2, 3})
            EXPECT_TRUE(test::sameBytes(one, buildWith(threads))) << nameOf(method);
    }
}

TEST(Builders, DepthIsBounded) {
    // Each triangle is 1.1 times as far away and as large as the one before; and beams, which are
    // cut over and over.
    Mesh peeled;
    for (int i = 0; i < 900; ++i) {
        const float size = std::pow(1.1f, float((i * 577) % 900 - 500));
        peeled.add(glm::vec3(size), size * glm::vec3(1.05f, 1, 1), size * glm::vec3(1, 1.05f, 1));
    }
    Random random(82);
    for (const Mesh& mesh : {peeled, beams(random, 900, 1)}) {
        for (const BuildMethod method : kMethods) {
            for (const int limit : {0, 10, 11, 13, 16}) {
                const Bvh bvh = buildTriangleBvh(
                    mesh.positions, mesh.triangles,
                    {.method = method, .maxLeafSize = 1, .maxDepth = limit, .maxDuplicates = 1});
                const int least = method == BuildMethod::kSpatial ? 11 : 10;  // of 1800 or 900
                EXPECT_LE(measure(bvh).depth, std::max(limit, least)) << nameOf(method);
                for (const int seen : test::countItems(bvh, mesh.triangles.size()))
                    ASSERT_GE(seen, 1);
            }
        }
    }
}

TEST(Builders, EqualTrianglesHalve) {
    Mesh mesh;
    for (int i = 0; i < 5000; ++i) mesh.add({0, 0, 0}, {1, 0, 1}, {0, 1, 1});
    for (const BuildMethod method : kMethods) {
        const BvhStatistics s = measure(build(mesh, method));
        EXPECT_LE(s.depth, 13) << nameOf(method);
        EXPECT_LE(s.maxLeaf, 4) << nameOf(method);
    }
}

}  // namespace
}  // namespace vitrine
