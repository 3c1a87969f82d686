// SPDX-License-Identifier: MIT
#include "scene/pose.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/test_scene.hpp"

namespace vitrine {
namespace {

using glm::vec3;

constexpr const char* kMoving = R"([scene]
[render]
exposure = 1
[[camera]]
name = "front"
eye = [0, 0, 5]
[[camera]]
name = "side"
[[light]]
name = "key"
[[light]]
name = "lamp"
type = "point"
[material.red]
roughness = 0.25
snippet = "a.mat.glsl"
[shape.ball]
sphere = {}
[shape.field]
sdf = "a.sdf.glsl"
[[node]]
name = "arm"
shape = "ball"
material = "red"
[[node]]
name = "hand"
parent = "arm"
shape = "field"
at = [2, 0, 0]
)";

Scene moving(const std::string& animations, const std::vector<std::string>& overrides = {}) {
    return goodScene(kMoving + animations, overrides);
}

std::string animation(const std::string& object, const std::string& param, const std::string& keys,
                      const std::string& more = "") {
    return "[[animation]]\n" + object + "\nparam = \"" + param + "\"\nkeys = " + keys + "\n" +
           more + "\n";
}

std::string wrong(const std::string& animations) {
    return problemsOf("[[camera]]\nname = \"front\"\n[[node]]\nname = \"arm\"\n[[animation]]\n" +
                      animations);
}

TEST(Pose, EveryKindOfObjectMoves) {
    const Scene scene = moving(
        animation("node = \"arm\"", "rotate", "[[0, [0, 0, 0]], [2, [0, 0, 90]]]") +
        animation("node = \"arm\"", "scale", "[[0, 1], [2, [1, 3, 1]]]") +
        animation("node = \"hand\"", "visible", "[[0, true], [1.5, false]]") +
        animation("node = \"hand\"", "set.morph", "[[0, 0.5], [2, 1.5]]") +
        animation("material = \"red\"", "roughness", "[[0, 0], [2, 1]]") +
        animation("material = \"red\"", "base_color", "[[0, \"#000000\"], [2, [1, 0.5, 0]]]") +
        animation("material = \"red\"", "set.tint", "[[0, [0, 0, 1]], [2, [1, 0, 1]]]") +
        animation("light = \"lamp\"", "at", "[[0, [0, 0, 0]], [2, [0, 8, 0]]]") +
        animation("camera = \"side\"", "eye", "[[0, [9, 0, 0]], [2, [7, 0, 0]]]") +
        animation("camera = \"side\"", "fov", "[[0, 40], [2, 60]]") +
        animation("", "render.exposure", "[[0, -8], [2, 0]]") +
        animation("", "environment.sky", "[[0, [0, 0, 0]], [2, [1, 1, 1]]]"));
    const Scene posed = poseScene(scene, 1);
    EXPECT_EQ(posed.nodes[0].rotate, vec3(0, 0, 45));
    EXPECT_EQ(posed.nodes[0].scale, vec3(1, 2, 1));
    EXPECT_TRUE(posed.nodes[1].visible);
    EXPECT_FALSE(poseScene(scene, 1.5).nodes[1].visible);
    EXPECT_EQ(posed.nodes[1].set.at(0).name, "morph");
    EXPECT_EQ(posed.nodes[1].set[0].value.x, 1);
    EXPECT_EQ(posed.materials[0].roughness, 0.5f);
    EXPECT_EQ(posed.materials[0].baseColor.rgb, vec3(0.5f, 0.25f, 0));
    EXPECT_EQ(posed.materials[0].set.at(0).components, 3);
    EXPECT_EQ(posed.materials[0].set[0].value, glm::vec4(0.5f, 0, 1, 0));
    EXPECT_EQ(posed.lights[1].at, vec3(0, 4, 0));
    EXPECT_EQ(posed.cameras[1].eye, vec3(8, 0, 0));
    EXPECT_EQ(posed.cameras[1].fov, 50);
    EXPECT_EQ(posed.cameras[1].focalLength, 0);
    EXPECT_EQ(posed.render.exposure, -4);
    EXPECT_EQ(posed.environment.zenith.rgb, vec3(0.5f));
    EXPECT_EQ(posed.environment.ground.rgb, vec3(0.5f));
    // The scene itself has not moved.
    EXPECT_EQ(scene.nodes[0].rotate, vec3(0));
    EXPECT_TRUE(scene.nodes[1].set.empty());
}

TEST(Pose, TheWholePathIsTheSameTarget) {
    for (const char* path : {"node.arm.at", "node.arm. at"}) {
        const Scene scene = moving(animation("", path, "[[0, [0, 0, 0]], [1, [3, 0, 0]]]"));
        EXPECT_EQ(poseScene(scene, 0.5).nodes[0].at, vec3(1.5f, 0, 0));
    }
    const Scene all = moving(animation("", "light.intensity", "[[0, 1], [1, 5]]") +
                             animation("", "camera.focal_length", "[[0, 20], [1, 40]]"));
    const Scene posed = poseScene(all, 0.5);
    EXPECT_EQ(posed.lights[0].intensity, 3);
    EXPECT_EQ(posed.lights[1].intensity, 3);
    EXPECT_EQ(posed.cameras[0].focalLength, 30);
    EXPECT_EQ(posed.cameras[1].focalLength, Camera::kDefaultFocalLength);
}

TEST(Pose, AChildIsCarriedByItsParent) {
    const Scene scene =
        moving(animation("node = \"arm\"", "rotate", "[[0, [0, 0, 0]], [4, [0, 0, 360]]]",
                         "loop = \"repeat\"") +
               animation("node = \"arm\"", "at", "[[0, [0, 0, 0]], [4, [0, 0, 8]]]"));
    for (const float time : {0.0f, 0.37f, 1.0f, 2.9f, 3.999f}) {
        const glm::mat4 hand = worldFromNodes(poseScene(scene, time))[1];
        const float angle = time / 4 * 2 * kPi;
        const vec3 want(2 * std::cos(angle), 2 * std::sin(angle), 2 * time);
        EXPECT_LT(glm::distance(vec3(hand[3]), want), 1e-5f) << time;
        EXPECT_LT(glm::distance(vec3(hand[0]), vec3(std::cos(angle), std::sin(angle), 0)), 1e-5f);
    }
}

TEST(Pose, AnOrientationStandsForRotate) {
    Scene scene = moving("");
    const glm::quat q = glm::angleAxis(glm::radians(70.0f), glm::normalize(vec3(1, 2, 3)));
    AnimationTrack track;
    track.target = {AnimationTarget::Object::kNode, 0, kOrientationKey};
    track.times = {0};
    track.values = {{q.x, q.y, q.z, q.w}};
    scene.animations.push_back(track);
    const glm::mat4 world = worldFromNodes(poseScene(scene, 0))[0], want = glm::mat4_cast(q);
    for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(world[i], want[i]), 1e-6f);
}

TEST(Pose, WhatSetGivesStays) {
    const std::string turn = animation("node = \"arm\"", "rotate", "[[0, [1, 1, 1]]]") +
                             animation("", "light.intensity", "[[0, 7]]");
    const Scene scene = moving(turn, {"node.arm.rotate=[5,6,7]", "light.lamp.intensity=2"});
    const Scene posed = poseScene(scene, 1);
    EXPECT_EQ(posed.nodes[0].rotate, vec3(5, 6, 7));
    EXPECT_EQ(posed.lights[0].intensity, 7);
    EXPECT_EQ(posed.lights[1].intensity, 2);
    EXPECT_EQ(scene.animations.size(), 1u);
    const Scene looped = moving(
        "[[animation]]\nname = \"a\"\nparam = \"render.gamma\"\n"
        "keys = [[0, 1], [1, 2]]\n",
        {"animation.a.loop=mirror"});
    EXPECT_EQ(looped.animations.at(0).loop, LoopMode::kMirror);
}

TEST(Pose, LightsTurnByAnglesOrByDirection) {
    // The light of the scene has a direction: its other angle is that of the direction.
    const Scene up = moving(animation("light = \"key\"", "polar", "[[0, 10], [1, 50]]"));
    const Light& before = up.lights[0];
    const glm::vec3 from = -travelOf(before), now = -travelOf(poseScene(up, 1).lights[0]);
    EXPECT_NEAR(now.y, std::cos(glm::radians(50.0f)), 1e-5f);
    EXPECT_NEAR(std::atan2(now.x, now.z), std::atan2(from.x, from.z), 1e-5f);
    Scene angles = moving(animation("light = \"key\"", "direction", "[[0, [0, 0, 1]]]"));
    angles.lights[0].polar = 20;
    EXPECT_EQ(travelOf(poseScene(angles, 0).lights[0]), glm::vec3(0, 0, 1));
}

TEST(Pose, WhatWouldBeImpossibleDoesNotHappen) {
    const Scene scene =
        moving(animation("camera = \"front\"", "eye", "[[0, [0, 0, 5]], [1, [0, 0.5, 0]]]") +
               animation("light = \"key\"", "direction", "[[0, [1, 0, 0]], [1, [-1, 0, 0]]]") +
               animation("node = \"arm\"", "scale", "[[0, 1], [1, 0]]"));
    const Scene end = poseScene(scene, 1);
    EXPECT_EQ(end.cameras[0].eye, scene.cameras[0].eye);
    EXPECT_EQ(poseScene(scene, 0.5).lights[0].direction, scene.lights[0].direction);
    EXPECT_FALSE(end.nodes[0].visible);
    EXPECT_FALSE(end.nodes[1].visible) << "it hangs on what is not there";
    EXPECT_TRUE(poseScene(scene, 0.99).nodes[1].visible);
}

TEST(Pose, MistakesAreNamedWithTheirPlace) {
    const std::string keys = "keys = [[0, [0, 0, 0]], [1, [1, 0, 0]]]\n";
    EXPECT_EQ(wrong("node = \"arn\"\nparam = \"at\"\n" + keys),
              "t:6:8: error: no node is named 'arn' (did you mean 'arm'?)");
    EXPECT_EQ(wrong("node = \"arm\"\nparam = \"rotat\"\n" + keys),
              "t:7:9: error: there is no 'rotat' to animate (did you mean 'rotate'?)");
    EXPECT_EQ(wrong("node = \"arm\"\nparam = \"shape\"\n" + keys),
              "t:7:9: error: 'shape' cannot change with time");
    EXPECT_EQ(wrong("param = \"render.bounces\"\nkeys = [[0, 1]]\n"),
              "t:6:9: error: 'bounces' cannot change with time");
    EXPECT_EQ(wrong("param = \"shape.ball.sphere.radius\"\n" + keys),
              "t:6:9: error: shapes do not change with time; a node's scale can");
    EXPECT_EQ(wrong("param = \"nodes.arm.at\"\n" + keys),
              "t:6:9: error: 'nodes' has nothing that can change with time (did you mean 'node'?)");
    EXPECT_EQ(wrong("param = \"node.at\"\n" + keys),
              "t:6:9: error: the key is missing, as in node.NAME.KEY");
    EXPECT_EQ(wrong("node = \"arm\"\n" + keys), "t:5:1: error: an animation needs param and keys");
    EXPECT_EQ(wrong("node = \"arm\"\ncamera = \"front\"\nparam = \"at\"\n" + keys),
              "t:7:10: error: give node or camera, not both");
    EXPECT_EQ(wrong("node = \"arm\"\nparm = \"at\"\nparam = \"at\"\n" + keys),
              "t:7:1: error: unknown key 'parm' in [[animation]] (did you mean 'param'?)");
    EXPECT_EQ(wrong("node = \"arm\"\nparam = \"at\"\nease = \"smoth\"\n" + keys),
              "t:8:8: error: ease must be one of 'linear', 'step', 'smooth', 'smoother', 'in', "
              "'out', not 'smoth' (did you mean 'smooth'?)");
    const std::string at = "node = \"arm\"\nparam = \"at\"\nkeys = ";
    EXPECT_EQ(wrong(at + "[[0, [0, 0, 0]], [0, [1, 0, 0]]]\n"),
              "t:8:26: error: times must grow from key to key; this one does not");
    EXPECT_EQ(wrong(at + "[[-1, [0, 0, 0]]]\n"),
              "t:8:10: error: the time is -1; it must be from 0 to 1000000");
    EXPECT_EQ(wrong(at + "[[0, [0, 0]]]\n"),
              "t:8:13: error: at must be three numbers, as in [0, 1, 2]");
    EXPECT_EQ(wrong(at + "[[0, 0, 0, 0]]\n"),
              "t:8:9: error: keys must be pairs, as in [[0, VALUE], [1.5, VALUE]]");
    EXPECT_EQ(wrong(at + "[]\n"),
              "t:8:8: error: keys must be pairs, as in [[0, VALUE], [1.5, VALUE]]");
    EXPECT_EQ(wrong(at + "[[0, [0, 0, 0]]]\nloop = \"repeat\"\n"),
              "t:8:8: error: a loop needs two keys or more");
    EXPECT_EQ(wrong(at + "[[0, [0, 0, 0]]]\n[[animation]]\nparam = \"node.arm.at\"\n" + keys),
              "t:10:9: error: this is animated already, at t:5:1");
    EXPECT_EQ(wrong("node = \"arm\"\nparam = \"set.a\"\nkeys = [[0, 1], [1, [1, 2]]]\n"),
              "t:8:21: error: this key has another number of components than the first");
    EXPECT_EQ(wrong("camera = \"front\"\nparam = \"fov\"\nkeys = [[0, 500]]\n"),
              "t:8:13: error: fov is 500; it must be from 0.1 to 170");
    std::string many = "[[0, 1]";
    for (int i = 1; i <= 10'000; ++i) many += fmt::format(",\n[{}, 1]", i);
    EXPECT_EQ(wrong("param = \"render.gamma\"\nkeys = " + many + "]\n"),
              "t:7:8: error: there are 10001 keys, at most 10000 are read");
}

TEST(Pose, ManyAnimationsAreReadInTime) {
    std::string text;
    for (int i = 0; i < 6000; ++i)
        text += fmt::format(
            "[[node]]\nname='n{0}'\n[[animation]]\nnode='n{0}'\nparam='at'\n"
            "keys=[[0,[0,0,{0}]]]\n",
            i);
    const Scene scene = goodScene(text);
    ASSERT_EQ(scene.animations.size(), 6000u);
    EXPECT_EQ(poseScene(scene, 0).nodes[5999].at.z, 5999);
}

}  // namespace
}  // namespace vitrine
