// SPDX-License-Identifier: MIT
// Models that move, in a scene, against the poses that gltf/pose.hpp gives of the file itself.
#include "import/model_animation.hpp"

#include "gltf/pose.hpp"
#include "gltf/test_model.hpp"
#include "import/import_models.hpp"
#include "import/model_mesh.hpp"
#include "scene/parse.hpp"
#include "scene/pose.hpp"

namespace vitrine {
namespace {

using nlohmann::json;

/// An arm that swings on a crane that travels, with a hand that grows, a camera and a lamp on it.
/// All three ways of interpolation, and channels that begin late and end early.
TestModel crane() {
    TestModel model = square();
    model.json["cameras"] = json::parse(R"([{"name": "eye", "type": "perspective",
        "perspective": {"yfov": 0.5, "znear": 0.1}}])");
    model.json["extensionsUsed"] = {"KHR_lights_punctual"};
    model.json["extensions"]["KHR_lights_punctual"]["lights"] =
        json::parse(R"([{"name": "lamp", "type": "spot"}])");
    model.json["nodes"] = json::parse(R"([
        {"name": "crane", "translation": [1, 2, 3], "scale": [2, 2, 2], "children": [1]},
        {"name": "arm", "rotation": [0, 0.6, 0, 0.8], "children": [2, 3], "mesh": 0},
        {"name": "hand", "translation": [0, 0, 1], "rotation": [0.6, 0, 0, 0.8], "mesh": 0},
        {"camera": 0, "translation": [0, 1, 0],
         "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "still", "mesh": 0, "translation": [9, 0, 0]}])");
    model.json["scenes"] = json::parse(R"([{"nodes": [0, 4]}])");
    const size_t early = model.addAccessor<float>({0, 0.5f, 2}, "SCALAR", 3);
    const size_t late = model.addAccessor<float>({1, 1.5f, 4}, "SCALAR", 3);
    const size_t places = model.addAccessor<float>({0, 0, 0, 4, 0, 0, 4, 3, 0}, "VEC3", 3);
    const size_t sizes = model.addAccessor<float>({1, 1, 1, 2, 1, 3, 1, 1, 0.5f}, "VEC3", 3);
    const size_t turns = model.addAccessor<float>(
        {0, 0, 0, 1, 0, 0.7f, 0, 0.7f, 0.5f, -0.5f, 0.5f, -0.5f}, "VEC4", 3);
    std::vector<float> spline;
    for (int key = 0; key < 3; ++key)
        for (const float f : {0.3f, 1.0f, -0.6f})
            for (int i = 0; i < 4; ++i)
                spline.push_back(f * (0.4f + 0.2f * static_cast<float>((key + i) % 4)));
    const size_t curve = model.addAccessor<float>(spline, "VEC4", 9);
    const auto sampler = [](size_t input, size_t output, const char* interpolation) {
        return json{{"input", input}, {"output", output}, {"interpolation", interpolation}};
    };
    const auto channel = [](int number, int node, const char* path) {
        return json{{"sampler", number}, {"target", {{"node", node}, {"path", path}}}};
    };
    model.json["animations"] = {
        {{"name", "Work"},
         {"samplers",
          {sampler(early, places, "LINEAR"), sampler(late, turns, "LINEAR"),
           sampler(early, sizes, "STEP"), sampler(late, curve, "CUBICSPLINE")}},
         {"channels",
          {channel(0, 0, "translation"), channel(1, 1, "rotation"), channel(2, 2, "scale"),
           channel(3, 2, "rotation")}}}};
    return model;
}

class ModelAnimation : public GltfTest {
  protected:
    Scene load(const TestModel& model, const std::string& more = "",
               const std::vector<std::string>& overrides = {}) {
        write("m.glb", model.glb());
        Diagnostics diagnostics;
        Scene scene =
            parseScene("[[node]]\nname = \"m\"\ninclude = \"m.glb\"\nat = [0, 0, 50]\n" + more,
                       (folder / "t").string(), overrides, diagnostics);
        ModelLibrary library;
        importModels(scene, library, diagnostics);
        messages = diagnostics.text();
        return scene;
    }
    static void expectNear(const glm::vec3& a, const glm::vec3& b) {
        EXPECT_LT(glm::distance(a, b), 1e-4f) << a.x << ' ' << a.y << ' ' << a.z;
    }
    static const Node& find(const Scene& scene, const std::string& name) {
        for (const Node& node : scene.nodes)
            if (node.name == name) return node;
        throw std::runtime_error("no node " + name);
    }
};

TEST_F(ModelAnimation, NodesAreWhereTheFileSaysAtEveryTime) {
    const TestModel file = crane();
    const GltfModel model = readGood(file);
    const Scene scene = load(file);
    EXPECT_EQ(messages, "");
    ASSERT_EQ(scene.animations.size(), 4u);
    const glm::mat4 base = glm::translate(glm::mat4(1), {0, 0, 50});
    float moved = 0;
    for (int i = 0; i <= 57; ++i) {
        const float time = 0.07f * static_cast<float>(i);
        const auto want = worldFromNodes(model, sampleAnimation(model, 0, time));
        for (const int round : {0, 3}) {
            const Scene posed = poseScene(scene, time + 4.0 * round);
            const auto world = worldFromNodes(posed);
            ASSERT_EQ(world.size(), want.size() + 1);
            const std::vector<int> order = nodesOfScene(model, 0);  // as nodes are added
            for (size_t n = 0; n < order.size(); ++n)
                for (int column = 0; column < 4; ++column)
                    EXPECT_LT(glm::distance(world[n + 1][column],
                                            (base * want[static_cast<size_t>(order[n])])[column]),
                              2e-4f)
                        << "time " << time << " round " << round << ' ' << posed.nodes[n + 1].name;
            const glm::mat4 eye = base * want[3];
            const Camera& camera = posed.cameras.at(0);
            expectNear(camera.eye, glm::vec3(eye[3]));
            expectNear(glm::normalize(camera.target - camera.eye),
                       -glm::normalize(glm::vec3(eye[2])));
            expectNear(glm::normalize(camera.up), glm::normalize(glm::vec3(eye[1])));
            expectNear(posed.lights.at(0).at, glm::vec3(eye[3]));
            expectNear(posed.lights[0].direction, -glm::normalize(glm::vec3(eye[2])));
            moved = std::max(moved, glm::distance(camera.eye, scene.cameras[0].eye));
        }
    }
    EXPECT_GT(moved, 3) << "the camera was carried along";
}

TEST_F(ModelAnimation, WhatSetGivesStays) {
    const Scene scene =
        load(crane(), "",
             {"node.m/crane.at=[7,7,7]", "node.m/arm.rotate=[0,90,0]", "light.m/lamp.at=[1,2,3]"});
    EXPECT_EQ(messages, "");
    EXPECT_EQ(scene.animations.size(), 2u);
    const Scene posed = poseScene(scene, 1.3);
    EXPECT_EQ(find(posed, "m/crane").at, glm::vec3(7));
    EXPECT_FALSE(find(posed, "m/arm").orientation.has_value());
    EXPECT_EQ(posed.lights[0].at, glm::vec3(1, 2, 3));
}

TEST_F(ModelAnimation, AnimationsOfTheSceneCarryCamerasOfModels) {
    TestModel still = crane();
    still.json.erase("animations");
    const Scene scene = load(still,
                             "[[animation]]\nnode = \"m\"\nparam = \"at\"\n"
                             "keys = [[0, [0, 0, 50]], [1, [0, 8, 50]]]\n");
    EXPECT_EQ(messages, "");
    expectNear(poseScene(scene, 1).cameras[0].eye, scene.cameras[0].eye + glm::vec3(0, 8, 0));
    expectNear(poseScene(scene, 1).lights[0].at, scene.lights[0].at + glm::vec3(0, 8, 0));
}

TEST_F(ModelAnimation, OneOfSeveralPlays) {
    TestModel model = crane();
    json other = model.json["animations"][0], empty = other;
    other["name"] = "Rest";
    other["channels"] = {other["channels"][0]};
    empty["name"] = "Face";
    empty["channels"] = json::array();
    model.json["animations"] = {empty, model.json["animations"][0], other};
    EXPECT_EQ(load(model).animations.size(), 4u);
    EXPECT_NE(messages.find("t:3:11: warning: 'm.glb' has more than one animation: 'Work' plays, "
                            "and not 'Face', 'Rest'; choose with animation = \"NAME\""),
              std::string::npos)
        << messages;
    EXPECT_EQ(load(model, "animation = \"Rest\"\n").animations.size(), 1u);
    EXPECT_EQ(messages, "");
    EXPECT_EQ(load(model, "", {"node.m.animation=Rest"}).animations.size(), 1u);
    EXPECT_EQ(load(model, "animation = \"none\"\n").animations.size(), 0u);
    EXPECT_EQ(messages, "");
    (void)load(model, "animation = \"Wrk\"\n");
    EXPECT_NE(messages.find("t:5:13: error: 'm.glb' has no animation 'Wrk' (did you mean 'Work'?)"),
              std::string::npos)
        << messages;
    (void)load(model, "", {"node.m/arm.animation=Work"});
    EXPECT_NE(messages.find("stand in a scene file only"), std::string::npos) << messages;
    (void)load(model, "[[node]]\nname = \"x\"\nanimation = \"Work\"\n");
    EXPECT_NE(messages.find("t:7:13: error: animation has no effect"), std::string::npos)
        << messages;
}

TEST_F(ModelAnimation, WhatIsScaledToNothingIsNotThereForAWhile) {
    TestModel model = crane();
    model.json["nodes"][2]["scale"] = {0, 0, 0};
    const size_t sizes = model.addAccessor<float>({0, 0, 0, 1, 1, 1, 0, 1, 1}, "VEC3", 3);
    model.json["animations"][0]["samplers"][2]["output"] = sizes;
    const Scene scene = load(model);
    EXPECT_EQ(messages, "") << "at rest it is nothing, but it moves";
    EXPECT_FALSE(find(scene, "m/hand").shape.empty());
    EXPECT_FALSE(find(poseScene(scene, 0.2), "m/hand").visible);
    EXPECT_TRUE(find(poseScene(scene, 1), "m/hand").visible);
    EXPECT_FALSE(find(poseScene(scene, 3), "m/hand").visible);
    EXPECT_TRUE(find(poseScene(scene, 3), "m/arm").visible);
}

TEST_F(ModelAnimation, TheBoxHoldsAllThatMoves) {
    const GltfModel model = readGood(crane());
    const Aabb box = boundsOverTime(model);
    for (int i = 0; i < 32; ++i) {
        const auto pose = sampleAnimation(model, 0, 4 * static_cast<float>(i) / 32);
        const Aabb now = boundsOfScene(model, pose);
        EXPECT_TRUE(glm::all(glm::lessThanEqual(box.min, now.min)));
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(box.max, now.max)));
    }
    EXPECT_GT(box.extent().x, 1.2f * boundsOfScene(model, restPose(model)).extent().x);
}

TEST_F(ModelAnimation, LongAnimationsAreNotCopiedWithoutEnd) {
    TestModel model = crane();
    std::vector<float> times, places;
    for (int i = 0; i < 300'000; ++i) {
        times.push_back(static_cast<float>(i));
        for (int k = 0; k < 3; ++k) places.push_back(0);
    }
    json& sampler = model.json["animations"][0]["samplers"][0];
    sampler["input"] = model.addAccessor(times, "SCALAR", times.size());
    sampler["output"] = model.addAccessor(places, "VEC3", times.size());
    std::string more;
    for (int i = 0; i < 30; ++i) more += "[[node]]\ninclude = \"m.glb\"\n";
    (void)load(model, more);
    EXPECT_NE(messages.find("too long together"), std::string::npos) << messages.substr(0, 300);
}

}  // namespace
}  // namespace vitrine
