// SPDX-License-Identifier: MIT
#include "app/viewer/camera_control.hpp"

#include <gtest/gtest.h>

#include "pack/camera.hpp"

namespace vitrine {
namespace {

Camera someCamera() {
    Camera camera;
    camera.eye = {3, 2, 4};
    camera.target = {0.5f, 0.5f, -0.25f};
    camera.fov = 40;
    return camera;
}

constexpr int kWidth = 900, kHeight = 600;

float heightOf(const Camera& camera) {
    return heightAtUnitDistance(camera, static_cast<float>(kWidth) / kHeight);
}

/// Where the renderer draws a point, in heights from the picture's middle.
glm::vec2 project(const Camera& camera, glm::vec3 point) {
    FrameBlock block{};
    packCamera(camera, kWidth, kHeight, block);
    const glm::vec4 clip = packProjection(block) * glm::vec4(point, 1);
    return 0.5f * glm::vec2(clip.x * kWidth / kHeight, clip.y) / clip.w;
}

TEST(CameraControl, TumbleKeepsTheDistanceAndTheTarget) {
    Camera camera = someCamera();
    const float distance = glm::distance(camera.eye, camera.target);
    const glm::vec3 before = project(camera, {0.5f, 0.5f, 1.0f}).x * glm::vec3(1);
    tumble(camera, {0.05f, 0});
    EXPECT_NEAR(glm::distance(camera.eye, camera.target), distance, 1e-4);
    EXPECT_EQ(camera.target, someCamera().target);
    // What is in front of the target follows the hand.
    EXPECT_GT(project(camera, {0.5f, 0.5f, 1.0f}).x, before.x);
    EXPECT_FLOAT_EQ(camera.eye.y, someCamera().eye.y);
}

TEST(CameraControl, TumbleStopsAtThePoles) {
    for (const float way : {1.0f, -1.0f}) {
        Camera camera = someCamera();
        for (int i = 0; i < 100; ++i) tumble(camera, {0.01f, way * 0.1f});
        const glm::vec3 back = glm::normalize(camera.eye - camera.target);
        EXPECT_NEAR(back.y, -way * std::sin(glm::radians(89.0f)), 1e-4);
        EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(frameOf(camera).right), glm::vec3(1.01f))));
    }
}

TEST(CameraControl, PanMovesTheTargetsPlaneWithTheCursor) {
    Camera camera = someCamera();
    const glm::vec3 point = camera.target;
    pan(camera, {0.2f, -0.1f}, heightOf(camera));
    EXPECT_NEAR(project(camera, point).x, 0.2f, 1e-4);
    EXPECT_NEAR(project(camera, point).y, -0.1f, 1e-4);
}

TEST(CameraControl, KnowsTheHeightOfEveryLens) {
    Camera camera = someCamera();
    for (const float focalLength : {0.0f, 24.0f, 85.0f}) {
        camera.focalLength = focalLength;
        camera.fov = focalLength > 0 ? 0 : 40;
        const CameraFrame f = frameOf(camera);
        const float edge = heightOf(camera) / 2;
        EXPECT_NEAR(project(camera, camera.eye - f.back + edge * f.up).y, 0.5f, 1e-4);
    }
}

TEST(CameraControl, DollyKeepsWhatIsUnderTheCursor) {
    Camera camera = someCamera();
    const CameraFrame f = frameOf(camera);
    const glm::vec2 cursor{0.3f, 0.2f};
    const float size = heightOf(camera) * glm::distance(camera.eye, camera.target);
    const glm::vec3 point = camera.target + size * (cursor.x * f.right + cursor.y * f.up);
    for (const float steps : {3.0f, -7.0f}) {
        dolly(camera, steps, cursor, heightOf(camera));
        EXPECT_NEAR(project(camera, point).x, cursor.x, 1e-4);
        EXPECT_NEAR(project(camera, point).y, cursor.y, 1e-4);
    }
    dolly(camera, 500, {0, 0}, heightOf(camera));
    EXPECT_GT(glm::distance(camera.eye, camera.target), 5e-4f);
}

TEST(CameraControl, LookingAroundTurnsTheViewWithTheCursor) {
    Camera camera = someCamera();
    const glm::vec3 point = camera.target;
    lookAround(camera, {-0.01f, 0.01f}, heightOf(camera));
    EXPECT_EQ(camera.eye, someCamera().eye);
    EXPECT_NEAR(project(camera, point).x, 0.01f, 2e-3);
    EXPECT_NEAR(project(camera, point).y, -0.01f, 2e-3);
}

TEST(CameraControl, WalkingStaysAtEyeHeight) {
    Camera camera = someCamera();
    walk(camera, {0, 0, 2}, false);
    EXPECT_FLOAT_EQ(camera.eye.y, 2);
    EXPECT_NEAR(glm::distance(camera.eye, someCamera().eye), 2, 1e-4);
    Camera flying = someCamera();
    walk(flying, {0, 0, 1}, true);
    const glm::vec3 way = glm::normalize(someCamera().target - someCamera().eye);
    EXPECT_NEAR(glm::distance(flying.eye, someCamera().eye + way), 0, 1e-4);
}

TEST(CameraControl, FlightEndsExactlyAndPassesItsBend) {
    Camera goal = someCamera();
    goal.eye = {-4, 1, 3};
    Flight flight(someCamera(), goal, 2);
    flight.bendThrough({0, 5, 5});
    EXPECT_NEAR(glm::distance(flight.eyeAt(0.5f), glm::vec3(0, 5, 5)), 0, 1e-4);
    Camera camera = someCamera();
    float largest = 0;
    for (int i = 0; i < 130 && flight.active(); ++i) {
        const glm::vec3 before = camera.eye;
        camera = flight.advance(1 / 60.0f);
        largest = std::max(largest, glm::distance(before, camera.eye));
    }
    EXPECT_FALSE(flight.active());
    EXPECT_EQ(camera.eye, goal.eye);
    EXPECT_EQ(camera.target, goal.target);
    EXPECT_LT(largest, 0.5f) << "no jump";
}

TEST(CameraControl, LookingAtShowsTheBall) {
    const glm::vec3 point{1, 2, 3};
    const Camera camera = lookingAt(someCamera(), point, 0.5f, heightOf(someCamera()));
    EXPECT_NEAR(glm::length(project(camera, point)), 0, 1e-5);
    const glm::vec2 edge = project(camera, point + 0.5f * frameOf(camera).up);
    EXPECT_NEAR(edge.y, 0.32f, 1e-3);
}

TEST(Flight, EndsWhereItsGoalHasGone) {
    Camera from, to, later;
    from.eye = {0, 0, 4};
    from.target = {0, 0, 0};
    to.eye = {4, 0, 0};
    to.target = {0, 0, 0};
    later.eye = {0, 3, -4};
    later.target = {0, 1, 0};
    Flight flight(from, to, 1);
    flight.advance(0.5f);
    flight.setGoal(later);
    const Camera almost = flight.advance(0.49f);
    EXPECT_LT(glm::distance(almost.eye, later.eye), 1e-2f);
    EXPECT_LT(glm::distance(almost.target, later.target), 5e-2f);
    const Camera end = flight.advance(0.1f);
    EXPECT_EQ(end.eye, later.eye);
    EXPECT_EQ(end.target, later.target);
    EXPECT_FALSE(flight.active());
}

}  // namespace
}  // namespace vitrine
