// SPDX-License-Identifier: MIT
#include "gltf/pose.hpp"

#include <cmath>

#include "gltf/test_model.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;

class GltfAnimations : public GltfTest {
  protected:
    GltfAnimations() {
        model.json["nodes"] = {{{"translation", {9, 0, 0}}}, {{"scale", {2, 2, 2}}}};
    }

    /// Adds a channel to the one animation.
    void animate(int node, const char* path, const char* interpolation,
                 const std::vector<float>& times, const std::vector<float>& values) {
        const bool isRotation = std::string_view(path) == "rotation";
        const size_t width = isRotation ? 4 : 3;
        addChannel(node, path, interpolation, model.addAccessor(times, "SCALAR", times.size()),
                   model.addAccessor(values, isRotation ? "VEC4" : "VEC3", values.size() / width));
    }
    void addChannel(int node, const char* path, const char* interpolation, size_t input,
                    size_t output) {
        Json& animation = model.json["animations"][0];
        animation["samplers"].push_back(
            {{"input", input}, {"output", output}, {"interpolation", interpolation}});
        animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                         {"target", {{"node", node}, {"path", path}}}});
    }
    static glm::vec3 translation(const GltfModel& read, int node, float time) {
        return sampleAnimation(read, 0, time)[node][3];
    }

    TestModel model;
};

TEST_F(GltfAnimations, LinearHoldsItsEnds) {
    animate(0, "translation", "LINEAR", {1, 2, 4}, {0, 0, 0, 1, 2, 3, 3, 2, 3});
    const GltfModel read = readGood(model);
    EXPECT_EQ(read.animations[0].name, "animation 0");
    EXPECT_EQ(read.animations[0].duration, 4);
    EXPECT_EQ(translation(read, 0, -1), glm::vec3(0, 0, 0));
    EXPECT_EQ(translation(read, 0, 1.5f), glm::vec3(0.5f, 1, 1.5f));
    EXPECT_EQ(translation(read, 0, 2), glm::vec3(1, 2, 3));
    EXPECT_EQ(translation(read, 0, 3), glm::vec3(2, 2, 3));
    EXPECT_EQ(translation(read, 0, 99), glm::vec3(3, 2, 3));
    EXPECT_EQ(sampleAnimation(read, 0, 0)[1], restPose(read)[1]) << "what nothing moves is at rest";
}

TEST_F(GltfAnimations, StepsJump) {
    animate(1, "scale", "STEP", {0, 1}, {1, 1, 1, 3, 4, 5});
    const GltfModel read = readGood(model);
    EXPECT_EQ(sampleAnimation(read, 0, 0.999f)[1][0].x, 1);
    EXPECT_EQ(sampleAnimation(read, 0, 1)[1][1].y, 4);
}

TEST_F(GltfAnimations, RotationsTakeTheShorterWay) {
    const float h = std::sqrt(0.5f);
    // A quarter turn about z; the second key is the same rotation with the other sign.
    animate(0, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, -h, -h});
    const GltfModel read = readGood(model);
    const glm::mat4 half = sampleAnimation(read, 0, 0.5f)[0];
    EXPECT_NEAR(half[0].x, h, 1e-5f);
    EXPECT_NEAR(half[0].y, h, 1e-5f);
    EXPECT_EQ(half[3].x, 9) << "the translation is at rest";
}

TEST_F(GltfAnimations, CubicSplinesFollowTheirTangents) {
    // From 0 to 1 within two seconds, leaving with slope 1 and arriving with slope -1.
    animate(0, "translation", "CUBICSPLINE", {0, 2},
            {7, 7, 7, 0, 0, 0, 1, 0, 0, -1, 0, 0, 1, 0, 0, 7, 7, 7});
    const GltfModel read = readGood(model);
    EXPECT_EQ(translation(read, 0, 0), glm::vec3(0));
    EXPECT_EQ(translation(read, 0, 2), glm::vec3(1, 0, 0));
    EXPECT_NEAR(translation(read, 0, 1).x, 0.5f + 2 * 0.125f + 2 * 0.125f, 1e-6f);
    const float slope = (translation(read, 0, 1e-3f).x - translation(read, 0, 0).x) / 1e-3f;
    EXPECT_NEAR(slope, 1, 1e-2f);
}

TEST_F(GltfAnimations, ReadsNormalizedRotations) {
    const size_t input = model.addAccessor<float>({0}, "SCALAR", 1);
    addChannel(1, "rotation", "STEP", input,
               model.addAccessor<int16_t>({0, 32767, 0, 0}, "VEC4", 1, {{"normalized", true}}));
    const GltfModel read = readGood(model);
    EXPECT_NEAR(sampleAnimation(read, 0, 0)[1][0].x, -2, 1e-5f)
        << "half a turn about y, scaled by 2";
}

TEST_F(GltfAnimations, AZeroScaleThatGrowsIsDrawn) {
    model.json["nodes"][1]["scale"] = {0, 0, 0};
    animate(1, "scale", "LINEAR", {0, 1}, {0, 0, 0, 1, 1, 1});
    const GltfModel read = readGood(model);
    EXPECT_FALSE(read.nodes[1].isSkipped);
    EXPECT_EQ(sampleAnimation(read, 0, 0.5f)[1][0].x, 0.5f);
}

TEST_F(GltfAnimations, WhatCannotBePlayedIsLeftOut) {
    const float inf = std::numeric_limits<float>::infinity();
    model.json["nodes"].push_back({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
    animate(0, "translation", "LINEAR", {0, 1, 1}, std::vector<float>(9, 0));
    animate(0, "translation", "LINEAR", {0, 1}, {0, 0, 0, inf, 0, 0});
    animate(2, "translation", "LINEAR", {0}, {1, 1, 1});
    animate(0, "weights", "LINEAR", {0}, {1, 1, 1});
    animate(0, "pointer", "LINEAR", {0}, {1, 1, 1});
    animate(0, "rotation", "LINEAR", {0}, {0, 0, 0, 0});
    const auto result = read(model.glb());
    EXPECT_EQ(
        messages,
        "m.glb: warning: /animations/0/samplers/0: the animation of one property is left out: "
        "the times do not grow\n"
        "m.glb: warning: /animations/0/samplers/1: the animation of one property is left out: a "
        "value is not a finite number\n"
        "m.glb: warning: /animations/0/channels/2/target: left out: a node with a matrix cannot "
        "be animated\n"
        "m.glb: warning: /animations/0/channels/3/target: morph targets are not supported; their "
        "animation is left out\n"
        "m.glb: warning: /animations/0/channels/4/target/path: 'pointer' cannot be animated; "
        "left out");
    ASSERT_TRUE(result);
    ASSERT_EQ(result->animations[0].channels.size(), 1u);
    EXPECT_EQ(sampleAnimation(*result, 0, 0), restPose(*result))
        << "a zero rotation changes nothing";
}

}  // namespace
}  // namespace vitrine
