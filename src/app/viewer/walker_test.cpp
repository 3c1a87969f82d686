// SPDX-License-Identifier: MIT
#include "app/viewer/walker.hpp"

#include <gtest/gtest.h>

#include "app/viewer/test_room.hpp"

namespace vitrine {
namespace {

using test::Room;

constexpr float kEye = 1.6f;

Camera looking(glm::vec3 eye, glm::vec3 way) {
    Camera camera;
    camera.eye = eye;
    camera.target = eye + way;
    return camera;
}

/// Goes on in small steps for some metres.
void goOn(Walker& walker, Camera& camera, const Room& room, float metres, glm::vec3 way) {
    constexpr float kStep = 0.03f;
    for (float gone = 0; gone < metres; gone += kStep)
        walker.go(camera, kStep * way, 0.02f, std::cref(room));
}

constexpr glm::vec3 kForward(0, 0, 1);

TEST(Walker, StopsInFrontOfAWallAndKeepsItsHeight) {
    // The same wall, turned and scaled to it.
    for (const char* place : {"", "rotate = [0, 90, 0]\nscale = [80, 1, -0.0125]"}) {
        SCOPED_TRACE(place);
        const Room room(Room::floor() + Room::box({0.1f, 3, 8}, {3, 1.5f, 0}, place));
        for (const float degrees : {0.0f, 3.0f, -8.0f}) {
            Walker walker;
            Camera camera = looking(
                {0, kEye, 0}, {1, -0.3f, std::tan(glm::radians(degrees))});  // looks down a bit
            goOn(walker, camera, room, 2, kForward);
            EXPECT_TRUE(walker.walks());
            EXPECT_GT(camera.eye.x, 1.8f);
            goOn(walker, camera, room, 3, kForward);
            EXPECT_NEAR(camera.eye.x, 2.95f - bodyOf(kEye).radius, 0.01f) << degrees;
            EXPECT_NEAR(camera.eye.y, kEye, 1e-3f);
            const float aside = camera.eye.z;
            EXPECT_GE(aside * degrees, 0) << "it slides the way it looks";
            goOn(walker, camera, room, 1, -kForward);
            EXPECT_LT(camera.eye.x, 1.8f) << "nothing holds it";
        }
    }
}

TEST(Walker, SlidesAlongAWallAndStopsInACorner) {
    const Room room(Room::floor() + Room::box({0.1f, 3, 12}, {3, 1.5f, 0}) +
                    Room::box({12, 3, 0.1f}, {0, 1.5f, 4}));
    Walker walker;
    Camera camera = looking({0, kEye, 0}, {1, 0, 0.7f});
    goOn(walker, camera, room, 5, kForward);
    const float radius = bodyOf(kEye).radius;
    EXPECT_NEAR(camera.eye.x, 2.95f - radius, 0.01f);
    EXPECT_GT(camera.eye.z, 2);
    goOn(walker, camera, room, 8, kForward);
    EXPECT_NEAR(camera.eye.x, 2.95f - radius, 0.02f);
    EXPECT_NEAR(camera.eye.z, 3.95f - radius, 0.02f);
}

TEST(Walker, CannotBeTalkedThroughAWallByLongSteps) {
    const Room room(Room::floor() + Room::box({0.02f, 3, 8}, {3, 1.5f, 0}));
    Walker walker;
    Camera camera = looking({0, kEye, 0}, {1, 0, 0});
    for (int i = 0; i < 5; ++i) walker.go(camera, {0, 0, 7}, 0.1f, std::cref(room));
    EXPECT_LT(camera.eye.x, 3);
}

TEST(Walker, IsStoppedByAPoleAndByATable) {
    for (const float aside : {-0.2f, -0.1f, 0.0f, 0.06f, 0.17f}) {
        const Room pole(Room::floor() + Room::box({0.12f, 3, 0.12f}, {2, 1.5f, aside}));
        Walker walker;
        Camera camera = looking({0, kEye, 0}, {1, 0, 0});
        goOn(walker, camera, pole, 4, kForward);
        EXPECT_LT(camera.eye.x, 1.75f) << aside;
    }
    const Room table(Room::floor() + Room::box({1, 0.05f, 1}, {2, 0.75f, 0}));
    Walker walker;
    Camera camera = looking({0, kEye, 0}, {1, 0, 0});
    goOn(walker, camera, table, 4, kForward);
    EXPECT_LT(camera.eye.x, 1.5f);
    EXPECT_NEAR(camera.eye.y, kEye, 1e-3f);
}

TEST(Walker, ClimbsStepsAndComesDownAgain) {
    std::string stair = Room::floor();
    for (int i = 1; i <= 5; ++i) {
        const float height = 0.2f * static_cast<float>(i);
        stair += Room::box({0.3f, height, 4}, {2 + 0.3f * static_cast<float>(i), height / 2, 0});
    }
    const Room room(stair + Room::box({2, 1, 4}, {4.65f, 0.5f, 0}));
    Walker walker;
    Camera camera = looking({0, kEye, 0}, {1, 0, 0});
    float last = camera.eye.y, leap = 0;
    for (int i = 0; i < 150; ++i) {
        walker.go(camera, {0, 0, 0.03f}, 0.02f, std::cref(room));
        leap = std::max(leap, camera.eye.y - last);
        last = camera.eye.y;
    }
    EXPECT_NEAR(camera.eye.x, 4.5f, 0.05f);
    for (int i = 0; i < 100; ++i) walker.go(camera, glm::vec3(0), 0.02f, std::cref(room));
    EXPECT_NEAR(camera.eye.y, 1 + kEye, 5e-3f);
    EXPECT_LT(leap, 0.1f) << "smoothly";
    EXPECT_FALSE(walker.go(camera, glm::vec3(0), 0.02f, std::cref(room))) << "it has settled";
    goOn(walker, camera, room, 4.5f, -kForward);
    for (int i = 0; i < 100; ++i) walker.go(camera, glm::vec3(0), 0.02f, std::cref(room));
    EXPECT_NEAR(camera.eye.y, kEye, 5e-3f);
}

TEST(Walker, WhatIsHigherThanAStepStopsIt) {
    const Room room(Room::floor() + Room::box({2, 0.6f, 8}, {3, 0.3f, 0}));
    Walker walker;
    Camera camera = looking({0, kEye, 0}, {1, 0, 0});
    goOn(walker, camera, room, 4, kForward);
    EXPECT_LT(camera.eye.x, 2.01f);
    EXPECT_NEAR(camera.eye.y, kEye, 1e-3f);
}

TEST(Walker, HighUpItFliesWhereItLooksAndWallsStopItThere) {
    const Room room(Room::floor() + Room::box({0.1f, 9, 40}, {6, 4.5f, 0}));
    Walker walker;
    Camera camera = looking({0, 5, 0}, {1, -0.2f, 0});
    goOn(walker, camera, room, 3, kForward);
    EXPECT_FALSE(walker.walks());
    EXPECT_LT(camera.eye.y, 4.6f);
    EXPECT_NEAR((camera.eye.y - 5) / camera.eye.x, -0.2f, 1e-3f);
    goOn(walker, camera, room, 6, kForward);
    EXPECT_LT(camera.eye.x, 5.95f);
    EXPECT_GT(camera.eye.x, 5.5f);
    goOn(walker, camera, room, 6, {0, -1, 0});  // down: lands
    EXPECT_GT(camera.eye.y, 0);
}

TEST(Walker, GoingUpAndDownChangesTheHeightThatItKeeps) {
    const Room room(Room::floor());
    Walker walker;
    Camera camera = looking({0, 1, 0}, {1, 0, 0});
    goOn(walker, camera, room, 0.6f, {0, 1, 0});
    for (int i = 0; i < 100; ++i) walker.go(camera, glm::vec3(0), 0.02f, std::cref(room));
    EXPECT_NEAR(camera.eye.y, 1.6f, 0.04f);
    goOn(walker, camera, room, 9, {0, -1, 0});
    for (int i = 0; i < 100; ++i) walker.go(camera, glm::vec3(0), 0.02f, std::cref(room));
    EXPECT_GT(camera.eye.y, 0.01f) << "not below the ground";
    camera.eye = {0, 1.3f, 0};  // somebody else moves it
    camera.target = {1, 1.3f, 0};
    goOn(walker, camera, room, 1, kForward);
    EXPECT_NEAR(camera.eye.y, 1.3f, 1e-3f);
    EXPECT_GT(camera.eye.x, 0.9f);
}

TEST(Walker, NothingBelowMeansThatItFlies) {
    const Room room(Room::box({1, 1, 1}, {0, 0, 0}));
    Walker walker;
    Camera camera = looking({0, 0, 4}, {0, 0, -1});
    goOn(walker, camera, room, 9, kForward);
    EXPECT_GT(camera.eye.z, 0.5f) << "not into the box";
    EXPECT_LT(camera.eye.z, 3);
}

}  // namespace
}  // namespace vitrine
