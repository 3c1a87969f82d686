// SPDX-License-Identifier: MIT
// Things that move: a picture at a time is the picture of a scene that stands as it stands then,
// whatever was drawn before it.
#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "mesh/primitives.hpp"
#include "scene/pose.hpp"

namespace vitrine {
namespace {

class MovingTest : public test::GpuTest {};

PictureRequest at(float time) {
    PictureRequest r;
    r.width = 160;
    r.height = 100;
    r.samples = 1;
    r.time = time;
    return r;
}

ImageRgba8 draw(Renderer& renderer, float time) {
    return renderer.draw(at(time), {});
}

/// A torus that a parent carries around, a field that grows, a box that is there for a while, a
/// light and a camera on their ways.
LoadedScene moving() {
    test::TestScene made;
    const int torus = made.addMesh(makeTorus(0.5f, 0.2f, 24, 12));
    const int box = made.addMesh(makeBox(glm::vec3(0.3f)));
    const int ball = made.addField(
        "// bounds[-1, -1, -1, 1, 1, 1]\nuniform float size; // slider[0.1, 0.5, 1]\n"
        "float sdf(vec3 p) { return length(p) - size; }\n");
    Material paint;
    paint.roughness = 0.6f;
    paint.baseColor = {{0.7f, 0.3f, 0.2f}};
    const int material = made.addMaterial(paint);
    Node& arm = made.add(torus, material);
    arm.name = "arm";
    Node& hand = made.add(torus, material);
    hand.parent.name = "arm";
    hand.at = {1.5f, 0, 0};
    made.add(ball, material).at = {-1, 0.5f, -1};
    // More boxes than the first moment has instances, so that the trees outgrow their place.
    for (int i = 0; i < 40; ++i) {
        Node& node = made.add(box, material);
        node.at = {-3 + 0.7f * static_cast<float>(i % 10), -1.5f,
                   -2 + 0.8f * static_cast<float>(i / 10)};
        node.visible = false;
    }
    made.setEnvironment(0.3f);
    Light lamp;
    lamp.type = LightType::kPoint;
    lamp.at = {2, 3, 2};
    lamp.intensity = 30;
    made.scene.lights.push_back(lamp);
    Camera camera;
    camera.eye = {0.5f, 1.5f, 5};
    camera.fov = 50;
    camera.focalLength = 0;
    made.scene.cameras = {camera};
    const auto move = [&](AnimationTarget::Object object, size_t index, const std::string& key,
                          const glm::vec4& from, const glm::vec4& to) {
        AnimationTrack track;
        track.target = {object, index, key};
        track.times = {0, 2};
        track.values = {from, to};
        made.scene.animations.push_back(track);
    };
    using Object = AnimationTarget::Object;
    move(Object::kNode, 0, "rotate", {0, 0, 0, 0}, {0, 160, 70, 0});
    move(Object::kNode, 2, "set.size", {0.2f, 0, 0, 0}, {0.9f, 0, 0, 0});
    for (size_t i = 3; i < 43; ++i) move(Object::kNode, i, "visible", {0, 0, 0, 0}, {1, 0, 0, 0});
    move(Object::kLight, 0, "at", {2, 3, 2, 0}, {-3, 3, 1, 0});
    move(Object::kCamera, 0, "eye", {0.5f, 1.5f, 5, 0}, {2, 2, 4, 0});
    move(Object::kMaterial, 0, "base_color", {0.7f, 0.3f, 0.2f, 0}, {0.1f, 0.3f, 0.8f, 0});
    move(Object::kRender, 0, "exposure", {0, 0, 0, 0}, {1, 0, 0, 0});
    return made.load();
}

/// The scene as it stands at a time, without animations.
LoadedScene still(const LoadedScene& loaded, float time) {
    LoadedScene other = loaded;
    other.scene = poseScene(loaded.scene, time);
    other.scene.animations.clear();
    Diagnostics diagnostics;
    other.packed = packScene(other.scene, other.assets, diagnostics);
    diagnostics.throwIfErrors();
    return other;
}

}  // namespace

TEST_F(MovingTest, APictureAtATimeIsThatOfTheSceneAsItStandsThen) {
    const LoadedScene loaded = moving();
    for (const Backend backend : test::kBackends)
        for (const float time : {0.0f, 0.7f, 1.3f}) {
            const ImageRgba8 picture = test::drawPicture(loaded, backend, at(time));
            EXPECT_EQ(picture, test::drawPicture(still(loaded, time), backend, at(0)))
                << test::nameOf(backend) << time;
            EXPECT_NE(picture, test::drawPicture(loaded, backend, at(time + 0.1f)))
                << "nothing moves";
        }
}

TEST_F(MovingTest, TheSameBytesAloneAndInARun) {
    const LoadedScene loaded = moving();
    const std::vector<float> times{0.0f, 1.9f, 0.4f, 1.1f, 1.1f, 0.0f};
    std::vector<ImageRgba8> pictures;
    {
        Renderer run(loaded, Backend::kFragment, false);
        for (const float time : times) pictures.push_back(draw(run, time));
    }
    for (size_t i = 0; i < times.size(); ++i)
        EXPECT_EQ(pictures[i], test::drawPicture(loaded, Backend::kFragment, at(times[i])))
            << times[i];
}

TEST_F(MovingTest, RasterAndTraceAgreeAtEveryTime) {
    const LoadedScene loaded = moving();
    for (const float time : {0.3f, 1.2f, 1.8f}) {
        PictureRequest request = at(time);
        request.primary = Primary::kTrace;
        const ImageRgba8 traced = test::drawPicture(loaded, Backend::kFragment, request);
        const ImageRgba8 raster = test::drawPicture(loaded, Backend::kFragment, at(time));
        EXPECT_LT(compareImages(raster, traced).fractionOver, 0.001) << time;
    }
}

TEST_F(MovingTest, AChangeByHandIsDrawn) {
    const LoadedScene loaded = moving();
    Scene changed = loaded.scene;
    changed.animations.clear();
    changed.nodes[0].at = {0, 0.4f, 0};
    changed.nodes[5].visible = true;
    ImageRgba8 before, after, again;
    {
        Renderer renderer(loaded, Backend::kFragment, false);
        before = draw(renderer, 0);
        renderer.change(changed);
        after = draw(renderer, 0);
        renderer.change(loaded.scene);
        again = draw(renderer, 0);
    }
    EXPECT_NE(after, before);
    EXPECT_EQ(again, before);
    LoadedScene fresh = loaded;
    fresh.scene = changed;
    EXPECT_EQ(after, test::drawPicture(still(fresh, 0), Backend::kFragment, at(0)));
}

TEST_F(MovingTest, WhatGoesWrongAtATimeIsSaid) {
    LoadedScene loaded = moving();
    loaded.scene.animations[0].target.key = "at";
    loaded.scene.animations[0].values[1] = {1e19f, 0, 0, 0};
    ImageRgba8 picture;
    {
        Renderer renderer(loaded, Backend::kFragment, false);
        (void)draw(renderer, 0);
        EXPECT_THROW((void)draw(renderer, 2), InputError);
        picture = draw(renderer, 0);
    }
    EXPECT_EQ(picture, test::drawPicture(loaded, Backend::kFragment, at(0)));
}

}  // namespace vitrine
