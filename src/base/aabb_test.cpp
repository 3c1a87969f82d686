// SPDX-License-Identifier: MIT
#include "base/aabb.hpp"

#include <gtest/gtest.h>

namespace vitrine {

TEST(Aabb, EmptyGrowsToAPoint) {
    Aabb box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.halfArea(), 0.0f);
    box.grow(glm::vec3(1, 2, 3));
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.min, glm::vec3(1, 2, 3));
    EXPECT_EQ(box.max, glm::vec3(1, 2, 3));
}

TEST(Aabb, TransformHoldsAllCorners) {
    const Aabb box{{-1, -2, -3}, {2, 1, 4}};
    glm::mat4 m = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    m = glm::translate(glm::mat4(1), {3, -1, 2}) * glm::scale(m, {1, -2, 0.5f});
    const Aabb moved = box.transformed(m);
    Aabb expected;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                               i & 4 ? box.max.z : box.min.z};
        expected.grow(glm::vec3(m * glm::vec4(corner, 1)));
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(moved.min[axis], expected.min[axis], 1e-5f);
        EXPECT_NEAR(moved.max[axis], expected.max[axis], 1e-5f);
    }
}

}  // namespace vitrine
