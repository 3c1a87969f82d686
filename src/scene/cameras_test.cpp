// SPDX-License-Identifier: MIT
#include "scene/cameras.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/pose.hpp"
#include "scene/test_scene.hpp"

namespace vitrine {
namespace {

using glm::vec3;

Camera cameraAt(const Scene& scene, double time, size_t index = 0) {
    return poseScene(scene, time).cameras.at(index);
}

void expectNear(const vec3& a, const vec3& b, float tolerance) {
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " instead of " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Cameras, AnOrbitIsACircleAtAnEvenSpeed) {
    const Scene scene = goodScene(R"([[camera]]
target = [1, 2, 3]
orbit = { distance = 10, elevation = 30, azimuth = 20, period = 7 }
)");
    for (const double time : {0.0, 0.1, 1.0, 3.3, 6.99, 7.0, 24.5}) {
        const double angle = glm::radians(20 + 360 * time / 7), flat = 10 * std::sqrt(0.75);
        const vec3 expected =
            vec3(1, 2, 3) + vec3(flat * std::sin(angle), 5, flat * std::cos(angle));
        expectNear(cameraAt(scene, time).eye, expected, 1e-4f);
        EXPECT_EQ(cameraAt(scene, time).target, vec3(1, 2, 3));
    }
    expectNear(scene.cameras[0].eye, cameraAt(scene, 0).eye, 1e-6f);
}

TEST(Cameras, AnOrbitBeginsAtTheEye) {
    const Scene scene = goodScene(
        "[[camera]]\neye = [4, 1, -3]\ntarget = [0, 0, 0]\n"
        "orbit = { period = 8 }\n");
    expectNear(scene.cameras[0].eye, vec3(4, 1, -3), 1e-5f);
    expectNear(cameraAt(scene, 4).eye, vec3(-4, 1, 3), 1e-5f);
    expectNear(cameraAt(scene, 2).eye, vec3(-3, 1, -4), 1e-5f);  // counterclockwise from above
}

TEST(Cameras, ANegativePeriodGoesClockwise) {
    const Scene scene = goodScene(
        "[[camera]]\neye = [4, 1, -3]\ntarget = [0, 0, 0]\n"
        "orbit = { period = -8 }\n");
    expectNear(cameraAt(scene, 2).eye, vec3(3, 1, 4), 1e-5f);
    expectNear(cameraAt(scene, 7).eye, vec3((4 - 3) / std::sqrt(2), 1, (-3 - 4) / std::sqrt(2)),
               1e-4f);
}

TEST(Cameras, TheCommandLineMakesATurntableOfAnyCamera) {
    const Scene scene = goodScene(
        "[[camera]]\n[[camera]]\nname = \"b\"\neye = [0, 0, 2]\n"
        "target = [0, 0, 0]\n",
        {"camera.b.orbit.period=4", "camera.b.orbit.distance=5"});
    EXPECT_EQ(scene.animations.size(), 1u);
    expectNear(cameraAt(scene, 1, 1).eye, vec3(5, 0, 0), 1e-5f);
    EXPECT_EQ(cameraAt(scene, 1).eye, scene.cameras[0].eye);
}

TEST(Cameras, TheOrbitOfTheFirstOneNeedsNoName) {
    for (const char* name : {"", "name = \"front\"\n"}) {
        const Scene scene = goodScene(std::string("[[camera]]\n") + name + "[[camera]]\n",
                                      {"camera.orbit.period=4"});
        EXPECT_TRUE(scene.cameras[0].orbit);
        EXPECT_FALSE(scene.cameras[1].orbit);
    }
    const Scene scene =
        goodScene("[[camera]]\n[[camera]]\nname = \"orbit\"\n", {"camera.orbit.fov=40"});
    EXPECT_EQ(scene.cameras[1].fov, 40);
}

constexpr const char* kRide = R"([[camera]]
name = "ride"
path = [[1, [0, 0, 9], [0, 0, 0]], [2, [2, 0, 9], [0, 1, 0]],
        [4, [4, 4, 9], [0, 1, 0]], [6, [4, 4, 9], [0, 2, 0]], [7, [0, 0, 9], [0, 0, 0]]]
)";

TEST(Cameras, APathPassesItsKeysWithoutAJolt) {
    const Scene scene = goodScene(kRide);
    const struct {
        double time;
        vec3 eye, target;
    } keys[] = {{0, {0, 0, 9}, {0, 0, 0}}, {1, {0, 0, 9}, {0, 0, 0}}, {2, {2, 0, 9}, {0, 1, 0}},
                {4, {4, 4, 9}, {0, 1, 0}}, {6, {4, 4, 9}, {0, 2, 0}}, {9, {0, 0, 9}, {0, 0, 0}}};
    for (const auto& key : keys) {
        expectNear(cameraAt(scene, key.time).eye, key.eye, 1e-5f);
        expectNear(cameraAt(scene, key.time).target, key.target, 1e-5f);
        // Coming as fast as going.
        const double h = 1e-2;
        const auto eye = [&](double time) { return cameraAt(scene, time).eye; };
        const vec3 coming = eye(key.time) - eye(key.time - h);
        const vec3 going = eye(key.time + h) - eye(key.time);
        expectNear(coming, going, 3e-3f);
    }
    // At the second key as fast as the parabola through it and its neighbours: uneven times.
    const vec3 speed = (cameraAt(scene, 2.01).eye - cameraAt(scene, 1.99).eye) / 0.02f;
    expectNear(speed, vec3((2 * 2.0f + 1 * 1.0f) / 3, 2.0f / 3, 0), 0.02f);
    // It waits where two keys are the same.
    for (const double time : {4.0, 4.3, 5.0, 5.9})
        EXPECT_EQ(cameraAt(scene, time).eye, vec3(4, 4, 9)) << time;
}

TEST(Cameras, ARoundGoesOnWhereItBegan) {
    const Scene scene = goodScene(R"([[camera]]
loop = "repeat"
path = [[0, [5, 1, 0], [0, 0, 0]], [1, [0, 1, 5], [0, 0, 0]], [2, [-5, 1, 0], [0, 0, 0]],
        [3, [0, 1, -5], [0, 0, 0]], [4, [5, 1, 0], [0, 0, 0]]]
)");
    const auto eye = [&](double time) { return cameraAt(scene, time).eye; };
    expectNear(eye(4.5), eye(0.5), 1e-5f);
    const vec3 coming = (eye(3.999) - eye(3.998)) / 0.001f;
    const vec3 going = (eye(4.002) - eye(4.001)) / 0.001f;
    EXPECT_GT(glm::length(coming), 3);
    expectNear(coming, going, 0.1f);
}

TEST(Cameras, WhatTheCommandLineSaysHolds) {
    const Scene ride = goodScene(kRide, {"camera.ride.eye=[1, 2, 3]"});
    EXPECT_EQ(ride.cameras[0].eye, vec3(1, 2, 3));
    EXPECT_EQ(cameraAt(ride, 2).eye, vec3(1, 2, 3));
    expectNear(cameraAt(ride, 2).target, vec3(0, 1, 0), 1e-5f);
    const Scene orbit = goodScene("[[camera]]\norbit = { period = 8 }\n", {"camera.eye=[1, 2, 3]"});
    EXPECT_EQ(cameraAt(orbit, 2).eye, vec3(1, 2, 3));
}

struct Case {
    const char* name;
    const char* camera;
    const char* problem;
};

class WrongCameras : public testing::TestWithParam<Case> {};

TEST_P(WrongCameras, AreRefusedWithTheirPlace) {
    EXPECT_EQ(problemsOf(std::string("[[camera]]\n") + GetParam().camera), GetParam().problem);
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongCameras,
    testing::Values(
        Case{"Both", "orbit = {}\npath = [[0, [1, 2, 3], [0, 0, 0]], [1, [3, 2, 1], [0, 0, 0]]]\n",
             "t:3:8: error: give orbit or path, not both"},
        Case{"EyeAndPath",
             "eye = [1, 2, 3]\npath = [[0, [1, 2, 3], [0, 0, 0]], [1, [3, 2, 1], [0, 0, 0]]]\n",
             "t:2:7: error: give eye and target, or path, not both"},
        Case{"UselessEye",
             "eye = [1, 2, 3]\norbit = { distance = 4, elevation = 2, azimuth = 3 }\n",
             "t:2:7: error: eye has no effect: orbit says where the camera begins"},
        Case{"NoPeriod", "orbit = { period = 0 }\n",
             "t:2:20: error: an orbit's period must not be 0"},
        Case{"NoTable", "orbit = 12\n",
             "t:2:9: error: orbit must be a table, as in { period = 12 }"},
        Case{"Misspelt", "orbit = { periode = 12 }\n",
             "t:2:11: error: unknown key 'periode' in orbit (did you mean 'period'?)"},
        Case{"FromAbove", "orbit = { elevation = 90 }\n",
             "t:2:23: error: elevation is 90; it must be from -89 to 89"},
        Case{"NoKeys", "path = []\n",
             "t:2:8: error: path must be two keys or more, as in [[0, [3, 2, 4], [0, 0.5, 0]], [5, "
             "EYE, TARGET]]"},
        Case{"HalfAKey", "path = [[0, [1, 2, 3], [0, 0, 0]], [1, [3, 2, 1]]]\n",
             "t:2:36: error: path must be two keys or more, as in [[0, [3, 2, 4], [0, 0.5, 0]], "
             "[5, EYE, TARGET]]"},
        Case{"BackInTime", "path = [[2, [1, 2, 3], [0, 0, 0]], [1, [3, 2, 1], [0, 0, 0]]]\n",
             "t:2:37: error: times must grow from key to key; this one does not"},
        Case{"AtItself", "path = [[0, [1, 2, 3], [0, 0, 0]], [1, [3, 2, 1], [3, 2, 1]]]\n",
             "t:2:36: error: the camera's eye and target are the same point"},
        Case{"NoNumber", "path = [[0, [1, 2, 3], [0, 0, 0]], [1, [3, nan, 1], [3, 2, 1]]]\n",
             "t:2:44: error: the eye must be finite"}),
    [](const auto& test) { return test.param.name; });

TEST(Cameras, AWayAndAnAnimationMayNotMeet) {
    EXPECT_EQ(problemsOf("[[camera]]\nname = \"c\"\norbit = {}\n[[animation]]\ncamera = \"c\"\n"
                         "param = \"eye\"\nkeys = [[0, [1, 2, 3]]]\n"),
              "t:6:9: error: this is animated already, at t:3:9");
}

}  // namespace
}  // namespace vitrine
