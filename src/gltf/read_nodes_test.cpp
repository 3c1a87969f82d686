// SPDX-License-Identifier: MIT
#include "gltf/pose.hpp"
#include "gltf/test_model.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;
using GltfNodes = GltfTest;

void expectPoint(const glm::mat4& matrix, const glm::vec3& point, const glm::vec3& expected) {
    const glm::vec3 got(matrix * glm::vec4(point, 1));
    EXPECT_LT(glm::length(got - expected), 1e-5f) << got.x << ' ' << got.y << ' ' << got.z;
}

TEST_F(GltfNodes, ComposesTransformsDownTheTree) {
    TestModel model;
    model.json["nodes"] = Json::parse(R"([
        {"name": "leaf", "translation": [1, 0, 0], "children": [3]},
        {"name": "root", "children": [2, 0], "translation": [0, 0, 5],
         "rotation": [0, 0, 0.70710678, 0.70710678], "scale": [2, 2, 2]},
        {"matrix": [1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 7, 0, 1]},
        {"translation": [0, 1, 0]}])");
    const GltfModel read = readGood(model);
    EXPECT_EQ(read.nodes[0].parent, 1);
    EXPECT_EQ(read.nodes[1].parent, kNoIndex);
    EXPECT_EQ(read.nodes[1].children, (std::vector<int>{2, 0}));
    EXPECT_EQ(read.nodes[2].name, "node 2");
    EXPECT_EQ(read.nodeOrder, (std::vector<int>{1, 2, 0, 3}));
    const auto world = worldFromNodes(read, restPose(read));
    expectPoint(world[1], {1, 0, 0}, {0, 2, 5});
    expectPoint(world[0], {0, 0, 0}, {0, 2, 5});
    expectPoint(world[2], {0, 0, 0}, {-14, 0, 5});
    expectPoint(world[3], {0, 0, 0}, {-2, 2, 5});
}

TEST_F(GltfNodes, WithoutScenesAllRootsAreOne) {
    TestModel model;
    model.json["nodes"] = Json::parse(R"([{"children": [1]}, {}, {}])");
    GltfModel read = readGood(model);
    ASSERT_EQ(read.scenes.size(), 1u);
    EXPECT_EQ(read.scene, 0);
    EXPECT_EQ(nodesOfScene(read, 0), (std::vector<int>{0, 2, 1}));
    model.json["scenes"] = Json::parse(R"([{"nodes": [0]}, {"name": "b", "nodes": [2]}])");
    model.json["scene"] = 1;
    read = readGood(model);
    EXPECT_EQ(read.scene, 1);
    EXPECT_EQ(read.scenes[1].name, "b");
    EXPECT_EQ(nodesOfScene(read, 0), (std::vector<int>{0, 1}));
    EXPECT_EQ(nodesOfScene(read, 1), (std::vector<int>{2}));
    EXPECT_EQ(readGood(TestModel{}).scenes.size(), 1u) << "a file of nothing is an empty scene";
}

TEST_F(GltfNodes, ReadsCameras) {
    TestModel model;
    model.json["cameras"] = Json::parse(R"([
        {"name": "wide", "type": "perspective",
         "perspective": {"yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1, "zfar": 100}},
        {"type": "perspective", "perspective": {"yfov": 1, "znear": 1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}}])");
    model.json["nodes"] = {{{"camera", 1}}};
    const auto result = read(model.glb());
    EXPECT_EQ(messages,
              "m.glb: warning: /cameras/2: orthographic cameras are not supported; left out");
    ASSERT_TRUE(result);
    EXPECT_EQ(result->nodes[0].camera, 1);
    EXPECT_EQ(result->cameras[0].name, "wide");
    EXPECT_EQ(result->cameras[0].yfov, 0.8f);
    EXPECT_EQ(result->cameras[0].aspectRatio, 1.5f);
    EXPECT_EQ(result->cameras[0].znear, 0.1f);
    EXPECT_EQ(result->cameras[0].zfar, 100);
    EXPECT_EQ(result->cameras[1].zfar, 0);
    EXPECT_TRUE(result->cameras[1].isPerspective);
    EXPECT_FALSE(result->cameras[2].isPerspective);
}

TEST_F(GltfNodes, ReadsLights) {
    TestModel model;
    model.json["extensionsUsed"] = {"KHR_lights_punctual"};
    model.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([
        {"type": "directional", "name": "sun", "color": [1, 0.9, 0.8], "intensity": 1000},
        {"type": "point", "range": 4},
        {"type": "spot", "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}},
        {"type": "spot"}])");
    model.json["nodes"] = {{{"extensions", {{"KHR_lights_punctual", {{"light", 2}}}}}},
                           Json::object()};
    const GltfModel read = readGood(model);
    ASSERT_EQ(read.lights.size(), 4u);
    EXPECT_EQ(read.nodes[0].light, 2);
    EXPECT_EQ(read.nodes[1].light, kNoIndex);
    EXPECT_EQ(read.lights[0].type, GltfLightType::kDirectional);
    EXPECT_EQ(read.lights[0].name, "sun");
    EXPECT_EQ(read.lights[0].color, glm::vec3(1, 0.9f, 0.8f));
    EXPECT_EQ(read.lights[0].intensity, 1000);
    EXPECT_EQ(read.lights[1].type, GltfLightType::kPoint);
    EXPECT_EQ(read.lights[1].range, 4);
    EXPECT_EQ(read.lights[1].intensity, 1);
    EXPECT_EQ(read.lights[2].innerConeAngle, 0.2f);
    EXPECT_EQ(read.lights[2].outerConeAngle, 0.5f);
    EXPECT_EQ(read.lights[3].type, GltfLightType::kSpot);
    EXPECT_NEAR(read.lights[3].outerConeAngle, kPi / 4, 1e-6f);
}

TEST_F(GltfNodes, UnusableTransformsAreSkippedWithAllBelow) {
    TestModel model;
    model.json["nodes"] = Json::parse(R"([
        {"rotation": [0, 0, 0, 0], "children": [6]},
        {"translation": [1e99, 0, 0]},
        {"scale": [1, 1, 0]},
        {"matrix": [1, 0, 0, 0.5,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1]},
        {"scale": [1e30, 1e30, 1e30], "children": [5]},
        {"scale": [1e30, 1e30, 1e30]},
        {},
        {"scale": [1e-6, 1e-6, 1e-6]},
        {"scale": [1, 1, -1e-6]}])");
    const auto result = read(model.glb());
    EXPECT_EQ(
        messages,
        "m.glb: warning: /nodes/0: left out, with all below it: its rotation is zero\n"
        "m.glb: warning: /nodes/1: left out, with all below it: its transform is infinite\n"
        "m.glb: warning: /nodes/2: left out, with all below it: its transform makes all flat\n"
        "m.glb: warning: /nodes/3: left out, with all below it: its matrix is a projection\n"
        "m.glb: warning: /nodes/5: left out, with all below it: its place in the world is "
        "infinite");
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->nodes[6].isSkipped);
    EXPECT_EQ(nodesOfScene(*result, 0), (std::vector<int>{4, 7, 8}));
}

TEST_F(GltfNodes, SkinsAreNamed) {
    TestModel model = square();
    model.json["skins"] = {{{"joints", {0}}}};
    model.json["nodes"][0]["skin"] = 0;
    EXPECT_TRUE(read(model.glb()));
    EXPECT_EQ(
        messages,
        "m.glb: warning: /nodes/0: skins are not supported; meshes stay as they were modelled");
}

}  // namespace
}  // namespace vitrine
