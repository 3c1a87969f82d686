// SPDX-License-Identifier: MIT
#include "app/viewer/way_round.hpp"

#include <gtest/gtest.h>

#include "app/viewer/projection.hpp"
#include "app/viewer/test_room.hpp"

namespace vitrine {
namespace {

using test::Room;

Camera at(glm::vec3 eye, glm::vec3 target = {0, 1, 0}) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
}

TEST(WayRound, IsStraightWhereNothingStands) {
    const Room room(Room::floor() + Room::box({1, 1, 1}, {0, 0.5f, 8}));
    EXPECT_FALSE(wayRound(at({-3, 1, 0}), at({3, 1, 0}), std::cref(room)));
}

TEST(WayRound, GoesOverAWallOrBesideAHighOne) {
    for (const float height : {2.0f, 30.0f}) {
        const Room room(Room::floor() + Room::box({0.2f, height, 3}, {0, height / 2, 0}));
        const Camera from = at({-3, 1, 0}), to = at({3, 1, 0.2f});
        Flight straight(from, to, 1);
        EXPECT_FALSE(isFree(straight, std::cref(room)));
        const auto point = wayRound(from, to, std::cref(room));
        ASSERT_TRUE(point) << height;
        Flight bent(from, to, 1);
        bent.bendThrough(*point);
        EXPECT_TRUE(isFree(bent, std::cref(room)));
        // A finer look at the way than the search's own.
        for (int i = 0; i < 500; ++i) {
            const glm::vec3 a = bent.eyeAt(static_cast<float>(i) / 500);
            const glm::vec3 b = bent.eyeAt(static_cast<float>(i + 1) / 500);
            EXPECT_FALSE(std::abs(a.x) < 0.1f && a.y < height && std::abs(a.z) < 1.5f);
            EXPECT_GT(b.y, 0);
        }
        EXPECT_EQ(point->y > 2, height < 10) << "over what is low";
    }
}

TEST(WayRound, OutOfAClosedRoomThereIsNone) {
    const Room room(Room::box({4, 4, 4}, {0, 0, 0}));
    EXPECT_FALSE(wayRound(at({0, 0, 0}, {1, 0, 0}), at({5, 0, 0}), std::cref(room)));
}

TEST(Screens, EndSquareInFrontAndFillTheView) {
    struct Case {
        const char* node;
        glm::vec3 size;
        bool isScreen;
    };
    const Case cases[] = {
        {"rotate = [0, 30, 0]", {1.6f, 0.9f, 0.01f}, true},
        {"rotate = [0, 200, 0]", {0.9f, 1.6f, 0.01f}, true},   // portrait
        {"rotate = [0, 0, 90]", {0.01f, 1.6f, 0.9f}, false},   // lies on the table
        {"rotate = [20, -40, 0]", {1.6f, 0.9f, 0.01f}, true},  // leans
        {"rotate = [0, 0, 25]", {1.6f, 0.9f, 0.01f}, true},    // hangs askew
        {"scale = [2, 1, 0.005]", {0.8f, 0.9f, 1}, true},      // by its scale
        {"scale = [-1, 1, 1]", {1.6f, 0.9f, 0.01f}, true},     // mirrored
        {"", {1.6f, 0.9f, 0.05f}, false},                      // too thick
        {"", {9, 0.9f, 0.01f}, false},                         // a plank
    };
    for (const Case& c : cases) {
        const Room room(Room::box(c.size, {1, 2, -3}, c.node));
        const PackedInstance& instance = room.instances().at(0);
        for (const glm::vec3& eye : {glm::vec3(0, 1, 4), glm::vec3(3, 2.5f, -9)}) {
            const auto screen = screenOf(instance.objectBox, instance.worldFromObject, eye);
            ASSERT_EQ(screen.has_value(), c.isScreen) << c.node << c.size.x;
            if (!screen) continue;
            for (const glm::vec2& size : {glm::vec2(640, 400), glm::vec2(300, 500)}) {
                const Camera goal = squareInFront(at(eye), *screen, size.x / size.y);
                EXPECT_TRUE(isSeen(*screen, goal, std::cref(room)));
                EXPECT_GT(glm::dot(eye - screen->centre, goal.eye - screen->centre), 0)
                    << "on this side of it";
                const Projection projection(goal, size);
                glm::vec2 low(1e9f), high(-1e9f);
                for (int i = 0; i < 8; ++i) {
                    const Aabb& box = instance.objectBox;
                    const glm::vec3 corner(i & 1 ? box.max.x : box.min.x,
                                           i & 2 ? box.max.y : box.min.y,
                                           i & 4 ? box.max.z : box.min.z);
                    const auto p = projection.place(
                        glm::vec3(instance.worldFromObject * glm::vec4(corner, 1)));
                    ASSERT_TRUE(p);
                    low = glm::min(low, *p);
                    high = glm::max(high, *p);
                }
                const glm::vec2 share = (high - low) / size;
                EXPECT_GT(std::max(share.x, share.y), 0.93f) << c.node;
                EXPECT_LT(std::max(share.x, share.y), 1.0f) << c.node;
                EXPECT_LT(glm::distance(0.5f * (low + high), 0.5f * size), 1.0f);
                const float aspect = share.x * size.x / (share.y * size.y);
                EXPECT_NEAR(aspect, screen->width / screen->height, 0.03f) << "square";
            }
        }
    }
}

TEST(Screens, AreNoneFromBehindAWall) {
    const Room room(Room::box({4, 3, 0.01f}, {0, 1.5f, 0}) + Room::box({9, 9, 0.2f}, {0, 1.5f, 1}));
    const PackedInstance& instance = room.instances().at(0);
    const auto screen = screenOf(instance.objectBox, instance.worldFromObject, {0, 1, 0.5f});
    ASSERT_TRUE(screen);
    EXPECT_FALSE(isSeen(*screen, squareInFront(at({0, 1, 0.5f}), *screen, 1.5f), std::cref(room)));
}

}  // namespace
}  // namespace vitrine
