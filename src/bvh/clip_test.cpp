// SPDX-License-Identifier: MIT
#include "bvh/clip.hpp"

#include <gtest/gtest.h>

#include "bvh/test_meshes.hpp"

namespace vitrine {
namespace {

using test::Random;

Aabb boxOf(const Corners& t) {
    Aabb box;
    for (const glm::vec3& p : t) box.grow(p);
    return box;
}

bool holds(const Aabb& box, const glm::dvec3& p, double slack) {
    for (int i = 0; i < 3; ++i)
        if (p[i] < double(box.min[i]) - slack || p[i] > double(box.max[i]) + slack) return false;
    return true;
}

TEST(Clip, ByHand) {
    // A right angle at the origin, cut at x = 1: the hypotenuse crosses at y = 1.
    const Corners triangle{glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(0, 2, 0)};
    const ClippedBoxes parts = clip(triangle, boxOf(triangle), 0, 1);
    EXPECT_EQ(parts.left.min, glm::vec3(0));
    EXPECT_EQ(parts.left.max, glm::vec3(1, 2, 0));
    EXPECT_EQ(parts.right.min, glm::vec3(1, 0, 0));
    EXPECT_EQ(parts.right.max.x, 2);
    EXPECT_NEAR(parts.right.max.y, 1, 1e-6);
    EXPECT_GE(parts.right.max.y, 1);
}

TEST(Clip, BesideTheTriangleOneSideIsEmpty) {
    const Corners triangle{glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(0, 2, 0)};
    EXPECT_TRUE(clip(triangle, boxOf(triangle), 0, 3).right.empty());
    EXPECT_TRUE(clip(triangle, boxOf(triangle), 0, -1).left.empty());
    // In a corner of its box that the right part does not reach.
    const Aabb corner{{1.5f, 1.5f, 0}, {2, 2, 0}};
    EXPECT_TRUE(clip(triangle, corner, 0, 1.75f).right.empty());
}

TEST(Clip, PartsHoldEveryPointAndAreTight) {
    Random random(61);
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        for (int round = 0; round < 4000; ++round) {
            const Corners triangle{random.point(scale), random.point(scale), random.point(scale)};
            const Aabb box = boxOf(triangle);
            const int axis = random.integer(0, 2);
            const float plane =
                box.min[axis] + random.uniform(0, 1) * (box.max[axis] - box.min[axis]);
            const ClippedBoxes parts = clip(triangle, box, axis, plane);
            const Aabb* sides[] = {&parts.left, &parts.right};
            Aabb exact[2];
            const auto visit = [&](const glm::dvec3& p) {
                for (int side = 0; side < 2; ++side) {
                    if (side == 0 ? p[axis] > double(plane) : p[axis] < double(plane)) continue;
                    ASSERT_TRUE(holds(*sides[side], p, 1e-15 * double(scale)))
                        << "seed 61, round " << round;
                    exact[side].grow(glm::vec3(p));
                }
            };
            const glm::dvec3 a(triangle[0]), b(triangle[1]), c(triangle[2]);
            for (int i = 0; i <= 64; ++i)
                for (int j = 0; i + j <= 64; ++j)
                    visit(a + (b - a) * (i / 64.0) + (c - a) * (j / 64.0));
            // The parts of 2145 points are a little smaller than the parts of the triangle.
            for (int side = 0; side < 2; ++side)
                if (!exact[side].empty()) {
                    EXPECT_LE(sides[side]->extent()[(axis + 1) % 3],
                              exact[side].extent()[(axis + 1) % 3] + 0.08f * scale);
                    EXPECT_LE(sides[side]->extent()[(axis + 2) % 3],
                              exact[side].extent()[(axis + 2) % 3] + 0.08f * scale);
                }
        }
    }
}

TEST(Clip, SliversAreLeftWhole) {
    EXPECT_TRUE(isClippable({glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)}));
    EXPECT_TRUE(isClippable({glm::vec3(0), glm::vec3(1e6f, 0, 0), glm::vec3(0, 2e3f, 0)}));
    EXPECT_FALSE(isClippable({glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0.5f, 1e-5f, 0)}));
    EXPECT_FALSE(isClippable({glm::vec3(1), glm::vec3(1), glm::vec3(1)}));
}

}  // namespace
}  // namespace vitrine
