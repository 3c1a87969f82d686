// SPDX-License-Identifier: MIT
#include "scene/parse.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/test_scene.hpp"

namespace vitrine {
namespace {

using glm::vec3;
using glm::vec4;

constexpr const char* kFullScene = R"([scene]
title = "Everything"
description = "one of each"
[render]
bounces = 7
samples = 9
exposure = -1.5
gamma = 1.1
tone_map = "none"
threshold = 0.25
ao = 0.5
ao_distance = 3
march_steps = 99
seed = 12
[[camera]]
name = "front"
eye = [1, 2, 3]
target = [0, 1, 0]
up = [0, 0, 1]
fov = 42
[[camera]]
name = "side"
eye = [9, 0, 0]
focal_length = 85
[environment]
zenith = [0.1, 0.2, 0.3]
horizon = "#ffffff"
ground = "#800000"
intensity = 2
[[light]]
name = "key"
direction = [0, -1, 0]
color = "#FF0000"
intensity = 4
[[light]]
name = "lamp"
type = "point"
at = [1, 1, 1]
[material.brass]
base_color = [0.9, 0.7, 0.3]
metallic = 1
roughness = 0.25
emission = [1, 0, 2]
emission_strength = 5
[material.wood]
snippet = "wood.mat.glsl"
set = { rings = 8, knots = true, offset = [1, 2], stain = "#000000", four = [1, 2, 3, 4] }
[shape.field]
sdf = "f.sdf.glsl"
[shape.model]
mesh = "m.obj"
[shape.box]
box = { size = [1, 2, 3] }
[shape.cube]
box = { size = 2 }
[shape.ball]
sphere = { radius = 3 }
[shape.floor]
plane = { size = [4, 0, 6] }
[shape.ring]
torus = { radius = 2, tube = 0.5 }
[shape.column]
cylinder = { radius = 0.3, height = 4 }
[[node]]
name = "base"
at = [1, 0, 0]
rotate = [0, 90, 0]
scale = 2
[[node]]
name = "thing"
parent = "base"
shape = "field"
material = "brass"
parts = { lid = "wood" }
set = { morph = 0.5 }
scale = [1, -2, 3]
visible = false
)";

TEST(ParseScene, ReadsEverySection) {
    const Scene s = goodScene(kFullScene);
    EXPECT_EQ(s.file, "folder/t.toml");
    EXPECT_EQ(s.folder, "folder");
    EXPECT_EQ(s.title, "Everything");
    EXPECT_EQ(s.description, "one of each");
    const RenderSettings& r = s.render;
    EXPECT_EQ(std::tie(r.bounces, r.samples, r.marchSteps, r.seed), std::make_tuple(7, 9, 99, 12));
    EXPECT_EQ(std::tie(r.exposure, r.gamma, r.threshold, r.ao, r.aoDistance),
              std::make_tuple(-1.5f, 1.1f, 0.25f, 0.5f, 3.0f));
    EXPECT_EQ(r.toneMap, ToneMap::kNone);
    EXPECT_EQ(s.environment.zenith.rgb, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(s.environment.intensity, 2);
    ASSERT_EQ(s.lights.size(), 2u);
    EXPECT_EQ(s.lights[0].direction, vec3(0, -1, 0));
    EXPECT_EQ(s.lights[0].intensity, 4);
    EXPECT_EQ(s.lights[1].type, LightType::kPoint);
    EXPECT_EQ(s.lights[1].at, vec3(1));
}

TEST(ParseScene, LightsHaveADirectionOrAngles) {
    const auto travel = [](const std::string& keys, const std::string& set = "light.name=sun") {
        return travelOf(goodScene("[[light]]\n" + keys, {set}).lights.at(0));
    };
    const auto expectSame = [](const vec3& a, const vec3& b) {
        EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << " " << a.y << " " << a.z;
    };
    expectSame(travel("polar = 0\n"), {0, -1, 0});
    expectSame(travel("polar = 180\n"), {0, 1, 0});
    expectSame(travel("polar = 90\n"), {0, 0, -1});
    expectSame(travel("polar = 90\nazimuth = 90\n"), {-1, 0, 0});
    expectSame(travel("polar = 60\nazimuth = 30\n"), {-std::sqrt(0.75f) * 0.5f, -0.5f, -0.75f});
    expectSame(travel("polar = 60\n", "light.azimuth=180"), {0, -0.5f, std::sqrt(0.75f)});
    expectSame(travel("direction = [0, 0, 5]\n"), {0, 0, 1});
    for (const vec3& direction : {vec3(1, -2, 3), vec3(-1, 2, 0.5f), vec3(0, -1, 0)}) {
        Light light;
        light.direction = direction;
        useAngles(light);
        EXPECT_GE(light.polar, 0);
        light.direction = {9, 9, 9};
        expectSame(travelOf(light), glm::normalize(direction));
    }
}

TEST(ParseScene, ReadsCameras) {
    const Scene s = goodScene(kFullScene);
    ASSERT_EQ(s.cameras.size(), 2u);
    EXPECT_EQ(s.cameras[0].name, "front");
    EXPECT_EQ(s.cameras[0].eye, vec3(1, 2, 3));
    EXPECT_EQ(s.cameras[0].target, vec3(0, 1, 0));
    EXPECT_EQ(s.cameras[0].up, vec3(0, 0, 1));
    EXPECT_EQ(s.cameras[0].fov, 42);
    EXPECT_EQ(s.cameras[0].focalLength, 0);
    EXPECT_EQ(s.cameras[0].where.line, 15);
    EXPECT_EQ(s.cameras[1].fov, 0);
    EXPECT_EQ(s.cameras[1].focalLength, 85);
}

TEST(ParseScene, ReadsBothSpellingsOfColours) {
    const Scene s = goodScene(kFullScene);
    EXPECT_EQ(s.environment.horizon.rgb, vec3(1));
    // 0x80 = 128: IEC 61966-2-1 gives ((128/255 + 0.055) / 1.055)^2.4.
    EXPECT_NEAR(s.environment.ground.rgb.x, 0.2158605f, 1e-6f);
    EXPECT_EQ(s.environment.ground.rgb.y, 0);
    EXPECT_EQ(s.lights[0].color.rgb, vec3(1, 0, 0));
    const Scene sky = goodScene("[environment]\nsky = \"#0a0000\"");
    EXPECT_NEAR(sky.environment.zenith.rgb.x, 10.0f / 255 / 12.92f, 1e-7f) << "the linear toe";
    EXPECT_EQ(sky.environment.zenith.rgb, sky.environment.horizon.rgb);
    EXPECT_EQ(sky.environment.zenith.rgb, sky.environment.ground.rgb);
}

TEST(ParseScene, ReadsMaterials) {
    const Scene s = goodScene(kFullScene);
    ASSERT_EQ(s.materials.size(), 2u);
    const Material& brass = s.materials[0];
    EXPECT_EQ(brass.name, "brass");
    EXPECT_EQ(brass.baseColor.rgb, vec3(0.9f, 0.7f, 0.3f));
    EXPECT_EQ(std::tie(brass.metallic, brass.roughness, brass.emissionStrength),
              std::make_tuple(1.0f, 0.25f, 5.0f));
    EXPECT_EQ(brass.emission.rgb, vec3(1, 0, 2));
    const Material& wood = s.materials[1];
    EXPECT_EQ(wood.snippet.name, "wood.mat.glsl");
    EXPECT_EQ(wood.snippet.where.text(), "folder/t.toml:46:11");
    ASSERT_EQ(wood.set.size(), 5u);
    const std::vector<std::tuple<std::string, vec4, int>> expected{{"four", {1, 2, 3, 4}, 4},
                                                                   {"knots", {1, 0, 0, 0}, 1},
                                                                   {"offset", {1, 2, 0, 0}, 2},
                                                                   {"rings", {8, 0, 0, 0}, 1},
                                                                   {"stain", {0, 0, 0, 1}, 3}};
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(std::make_tuple(wood.set[i].name, wood.set[i].value, wood.set[i].components),
                  expected[i]);
    EXPECT_EQ(wood.set[3].where.line, 47);
}

TEST(ParseScene, ReadsShapes) {
    const Scene s = goodScene(kFullScene);
    ASSERT_EQ(s.shapes.size(), 8u);
    const auto shape = [&](const std::string& name) {
        for (const Shape& candidate : s.shapes)
            if (candidate.name == name) return candidate;
        return Shape{};
    };
    EXPECT_EQ(shape("field").sdf.name, "f.sdf.glsl");
    EXPECT_EQ(shape("model").mesh.name, "m.obj");
    EXPECT_EQ(shape("box").box->size, vec3(1, 2, 3));
    EXPECT_EQ(shape("cube").box->size, vec3(2)) << "one number is all three";
    EXPECT_EQ(shape("ball").sphere->radius, 3);
    EXPECT_EQ(shape("floor").plane->size, vec3(4, 0, 6));
    EXPECT_EQ(shape("ring").torus->radius, 2);
    EXPECT_EQ(shape("ring").torus->tube, 0.5f);
    EXPECT_EQ(shape("column").cylinder->radius, 0.3f);
    EXPECT_EQ(shape("column").cylinder->height, 4);
    EXPECT_FALSE(shape("field").box || shape("field").sphere || shape("ball").box);
}

TEST(ParseScene, ReadsNodes) {
    const Scene s = goodScene(kFullScene);
    ASSERT_EQ(s.nodes.size(), 2u);
    EXPECT_EQ(s.nodes[0].scale, vec3(2)) << "one number is all three";
    EXPECT_EQ(s.nodes[0].rotate, vec3(0, 90, 0));
    EXPECT_TRUE(s.nodes[0].visible);
    const Node& thing = s.nodes[1];
    EXPECT_EQ(thing.parent.name, "base");
    EXPECT_EQ(thing.shape.name, "field");
    EXPECT_EQ(thing.material.name, "brass");
    ASSERT_EQ(thing.parts.size(), 1u);
    EXPECT_EQ(thing.parts[0].first, "lid");
    EXPECT_EQ(thing.parts[0].second.name, "wood");
    EXPECT_EQ(thing.partPlaces[0].text(), "folder/t.toml:74:11");
    ASSERT_EQ(thing.set.size(), 1u);
    EXPECT_EQ(thing.set[0].value.x, 0.5f);
    EXPECT_EQ(thing.scale, vec3(1, -2, 3));
    EXPECT_FALSE(thing.visible);
}

TEST(ParseScene, AnEmptySceneHasOneCamera) {
    const Scene s = goodScene("");
    ASSERT_EQ(s.cameras.size(), 1u);
    EXPECT_EQ(s.cameras[0].focalLength, Camera::kDefaultFocalLength);
    EXPECT_TRUE(s.nodes.empty() && s.lights.empty() && s.materials.empty() && s.shapes.empty());
}

/// Where the node "n" of this text takes a point.
vec3 placed(const std::string& nodes, const vec3& point) {
    const Scene scene = goodScene(nodes);
    return vec3(worldFromNodes(scene).back() * vec4(point, 1));
}

void expectNear(const vec3& a, const vec3& b) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-5f) << "axis " << axis;
}

TEST(WorldFromNodes, ScalesThenRotatesThenMoves) {
    expectNear(placed("[[node]]\nscale = [2, 3, 4]\nat = [10, 20, 30]", {1, 1, 1}), {12, 23, 34});
    // A quarter turn about each axis, right-handed.
    expectNear(placed("[[node]]\nrotate = [90, 0, 0]", {0, 1, 0}), {0, 0, 1});
    expectNear(placed("[[node]]\nrotate = [0, 90, 0]", {0, 0, 1}), {1, 0, 0});
    expectNear(placed("[[node]]\nrotate = [0, 0, 90]", {1, 0, 0}), {0, 1, 0});
    // x first: y goes to z, which y's turn takes to x. The other order would leave it at z.
    expectNear(placed("[[node]]\nrotate = [90, 90, 0]", {0, 1, 0}), {1, 0, 0});
    // ... and z last: x (from y via z) goes on to y.
    expectNear(placed("[[node]]\nrotate = [90, 90, 90]", {0, 1, 0}), {0, 1, 0});
    // Scaled along its own axes, before the turn.
    expectNear(placed("[[node]]\nrotate = [0, 0, 90]\nscale = [5, 1, 1]", {1, 0, 0}), {0, 5, 0});
}

TEST(WorldFromNodes, ParentsMayStandAnywhere) {
    const std::string nodes = R"([[node]]
name = "arm"
parent = "body"
at = [1, 0, 0]
scale = 2
[[node]]
name = "body"
at = [0, 10, 0]
rotate = [0, 0, 90]
[[node]]
name = "hand"
parent = "arm"
at = [3, 0, 0]
)";
    // hand (0,0,0) -> arm (3,0,0) -> body 2 * 3 + 1 = (7,0,0) -> turned (0,7,0) -> (0,17,0).
    expectNear(placed(nodes, {0, 0, 0}), {0, 17, 0});
    const auto world = worldFromNodes(goodScene(nodes));
    expectNear(vec3(world[0][3]), {0, 11, 0});
    expectNear(vec3(world[1][3]), {0, 10, 0});
}

TEST(WorldFromNodes, SurvivesACircleMadeByCode) {
    Scene scene;
    scene.nodes.resize(2);
    scene.nodes[0].name = scene.nodes[1].parent.name = "a";
    scene.nodes[1].name = scene.nodes[0].parent.name = "b";
    scene.nodes[0].at = {1, 0, 0};
    scene.nodes[1].at = {0, 2, 0};
    // The second closes the circle: it counts as without a parent.
    const auto world = worldFromNodes(scene);
    expectNear(vec3(world[0][3]), {1, 2, 0});
    expectNear(vec3(world[1][3]), {0, 2, 0});
}

TEST(WorldFromNodes, LongChainsAreQuick) {
    std::string text;
    for (int i = 0; i < 20000; ++i) {
        text += "[[node]]\nname='" + std::to_string(i) + "'\nat=[1,0,0]\n";
        if (i > 0) text += "parent='" + std::to_string(i - 1) + "'\n";
    }
    expectNear(placed(text, {0, 0, 0}), {20000, 0, 0});
}

}  // namespace
}  // namespace vitrine
