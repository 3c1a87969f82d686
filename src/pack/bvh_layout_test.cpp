// SPDX-License-Identifier: MIT
#include "pack/bvh_layout.hpp"

#include <gtest/gtest.h>

#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"
#include "bvh/traverse.hpp"
#include "pack/slot_walk.hpp"

namespace vitrine {
namespace {

using glm::vec3;

bool contains(const Aabb& outer, const Aabb& inner) {
    return glm::all(glm::lessThanEqual(outer.min, inner.min)) &&
           glm::all(glm::greaterThanEqual(outer.max, inner.max));
}

/// Children in a node whose size and place differ by `size` and `offset`.
std::vector<Aabb> randomChildren(test::Random& random, float size, float offset, int kind) {
    std::vector<Aabb> boxes;
    const vec3 centre = random.point(offset);
    for (int i = random.integer(1, 4); i > 0; --i) {
        Aabb box;
        box.grow(centre + random.point(size));
        if (kind != 0) box.grow(centre + random.point(size));                 // else a point
        if (kind == 2) box.min.y = box.max.y;                                 // flat
        if (kind == 3) box.max.x = box.min.x = box.min.z = box.max.z = 0.1f;  // a line
        boxes.push_back(box);
    }
    return boxes;
}

TEST(Quantise, BoxesContainTheirOriginals) {
    test::Random random(1);
    for (const float size : {0.0f, 1e-20f, 1e-9f, 1e-3f, 1.0f, 1e3f, 1e9f, 1e18f})
        for (const float offset : {0.0f, 1e-9f, 1.0f, 1e9f, 1e18f})
            for (int round = 0; round < 400; ++round) {
                const std::vector<Aabb> boxes = randomChildren(random, size, offset, round % 4);
                const QuantisedNode node = quantise(boxes);
                for (size_t i = 0; i < boxes.size(); ++i) {
                    const Aabb seen = dequantise(node, static_cast<int>(i));
                    ASSERT_TRUE(isFinite(seen.min) && isFinite(seen.max));
                    ASSERT_TRUE(contains(seen, boxes[i]))
                        << "size " << size << ", offset " << offset << ", round " << round;
                }
            }
}

TEST(Quantise, BoxesAreTight) {
    test::Random random(2);
    for (int round = 0; round < 2000; ++round) {
        const std::vector<Aabb> boxes = randomChildren(random, 1, 1, 1);
        Aabb whole;
        for (const Aabb& box : boxes) whole.grow(box);
        const QuantisedNode node = quantise(boxes);
        // A step is at most 2/255 of the node: the smallest power of two of which 255 suffice.
        const vec3 slack = whole.extent() * (2.02f / 255) + 1e-6f;
        for (size_t i = 0; i < boxes.size(); ++i) {
            const Aabb seen = dequantise(node, static_cast<int>(i));
            ASSERT_TRUE(contains({boxes[i].min - slack, boxes[i].max + slack}, seen)) << round;
        }
    }
}

struct Packed {
    test::Mesh mesh;
    Bvh bvh;
    BvhLayout layout;
    uint32_t root;

    explicit Packed(test::Mesh m) : mesh(std::move(m)) {
        bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
        root = layout.addMesh(bvh, mesh.positions, mesh.triangles);
    }
};

std::vector<test::Mesh> meshes() {
    test::Random random(3);
    std::vector<test::Mesh> list{
        test::soup(random, 1, 1, 1),           test::soup(random, 3, 1, 1),
        test::soup(random, 4, 1, 1),           test::soup(random, 5, 1, 1),
        test::soup(random, 3000, 1, 0.1f),     test::soup(random, 500, 1e9f, 1e8f),
        test::soup(random, 500, 1e-9f, 1e-9f), test::hostileSoup(random, 2000, 1),
        test::sphere(40, 60, 2, vec3(3))};
    test::Mesh same;  // cannot be divided but by number
    for (int i = 0; i < 300; ++i) same.add(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0));
    list.push_back(same);
    return list;
}

TEST(BvhLayout, EveryTriangleIsReachedOnceInsideItsBoxes) {
    for (const test::Mesh& mesh : meshes()) {
        const Packed packed(mesh);
        std::vector<int> seen(mesh.triangles.size(), 0);
        int deepest = 0;
        test::forEachTriangle(
            packed.layout.texels(), packed.root,
            [&](uint32_t triangle, const std::array<vec3, 3>& corners, const Aabb& box, int stack) {
                ASSERT_LT(triangle, seen.size());
                ++seen[triangle];
                deepest = std::max(deepest, stack);
                for (int i = 0; i < 3; ++i) {
                    const vec3& p = mesh.positions[mesh.triangles[triangle][i]];
                    ASSERT_EQ(corners[static_cast<size_t>(i)], p);
                    ASSERT_TRUE(contains(box, {p, p}));
                }
            });
        for (const int count : seen) ASSERT_EQ(count, 1);
        EXPECT_EQ(packed.layout.stackBound(), deepest) << mesh.triangles.size();
    }
}

TEST(BvhLayout, TheShadersWalkFindsWhatTheCpuFinds) {
    test::Random random(4);
    int hits = 0;
    for (const test::Mesh& mesh : meshes()) {
        const Packed packed(mesh);
        const Aabb box = packed.bvh.box();
        const float reach = 1.5f * glm::length(box.extent()) + 1e-12f;
        for (int round = 0; round < 600; ++round) {
            Ray ray = test::ray(random, reach);
            ray.origin += box.centre();
            // Two thirds of the rays aim at a triangle, or few would meet any.
            const int target = random.integer(0, static_cast<int>(mesh.triangles.size()) - 1);
            const glm::uvec3& t = mesh.triangles[static_cast<size_t>(target)];
            const vec3 middle =
                (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
            if (round % 3 != 0 && middle != ray.origin) ray.direction = middle - ray.origin;
            const auto expected = closestHit(packed.bvh, mesh.positions, mesh.triangles, ray);
            const test::SlotHit found = test::walkSlots(packed.layout.texels(), packed.root, ray);
            // Several triangles may share the nearest point; which is found first is a matter of
            // the tree's order.
            ASSERT_EQ(found.hit, expected.has_value()) << round;
            if (expected) {
                ASSERT_EQ(found.t, expected->t) << round;
            }
            ASSERT_LE(found.stack, packed.layout.stackBound());
            hits += found.hit ? 1 : 0;
        }
    }
    EXPECT_GT(hits, 2000) << "too few rays hit anything to prove something";
}

TEST(BvhLayout, InstancesAreReachedOnce) {
    test::Random random(5);
    std::vector<Aabb> boxes = test::soup(random, 777, 10, 1).boxes();
    BuildOptions options;
    options.maxLeafSize = 1;
    BvhLayout layout;
    // Numbered backwards, so that an item is not taken for its instance.
    std::vector<uint32_t> numbers(boxes.size());
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<uint32_t>(numbers.size() - 1 - i);
    const uint32_t root = layout.addInstances(buildBvh(boxes, options), numbers);
    std::vector<int> seen(boxes.size(), 0);
    test::forEachLeaf(layout.texels(), root, [&](uint32_t slot, const Aabb& box, int stack) {
        const uint32_t instance = layout.texels()[slot * VITRINE_SLOT_TEXELS].x;
        ASSERT_LT(instance, seen.size());
        ++seen[instance];
        EXPECT_TRUE(contains(box, boxes[numbers[instance]]));
        EXPECT_LE(stack, layout.stackBound());
    });
    for (const int count : seen) EXPECT_EQ(count, 1);
}

TEST(BvhLayout, BothLevelsShareTheStack) {
    test::Random random(6);
    const test::Mesh small = test::soup(random, 50, 1, 0.1f),
                     large = test::soup(random, 5000, 1, 0.1f);
    const int smallBound = Packed(small).layout.stackBound();
    Packed both(large);
    const int largeBound = both.layout.stackBound();
    EXPECT_GT(largeBound, smallBound);
    both.layout.addMesh(buildTriangleBvh(small.positions, small.triangles), small.positions,
                        small.triangles);
    EXPECT_EQ(both.layout.stackBound(), largeBound) << "a ray is in one mesh at a time";
    BvhLayout upper;
    const std::vector<Aabb> boxes = small.boxes();
    const std::vector<uint32_t> numbers(boxes.size(), 0);
    upper.addInstances(buildBvh(boxes), numbers);
    both.layout.addInstances(buildBvh(boxes), numbers);
    EXPECT_EQ(both.layout.stackBound(), largeBound + upper.stackBound());
    both.layout.clear();
    EXPECT_EQ(both.layout.stackBound(), 0);
    EXPECT_TRUE(both.layout.texels().empty());
}

}  // namespace
}  // namespace vitrine
