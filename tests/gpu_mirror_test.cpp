// SPDX-License-Identifier: MIT
// Mirrors. What a plane mirror shows is what a mirrored camera sees, flipped: at most 0.1 % of the
// pixels may be off by more than 5 of 255 (rays start lifted off the mirror, by 1e-5 of the
// distance, which shows at outlines only).
#include <algorithm>

#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 240, kHeight = 150;

class MirrorTest : public test::GpuTest {};

Material mirrorMaterial() {
    Material mirror;
    mirror.baseColor.rgb = glm::vec3(1);
    mirror.metallic = 1;
    mirror.roughness = 0;
    return mirror;
}

ImageRgba8 draw(const test::TestScene& scene, Backend backend) {
    PictureRequest request;
    request.width = kWidth;
    request.height = kHeight;
    request.samples = 1;
    return test::drawPicture(scene.load(), backend, request);
}

/// Things above the plane y = 0; the plane is the last node.
test::TestScene thingsOverAMirror(bool field) {
    test::TestScene scene;
    Material clay;
    clay.baseColor.rgb = {0.8f, 0.4f, 0.2f};
    clay.roughness = 0.6f;
    const int body = scene.addMaterial(clay), mirror = scene.addMaterial(mirrorMaterial());
    if (field) {
        scene.add(scene.addField("// bounds[-1.3, -0.4, -1.3, 1.3, 0.4, 1.3]\n"
                                 "float sdf(vec3 p) {\n"
                                 "return length(vec2(length(p.xz) - 0.9, p.y)) - 0.3; }"),
                  body);
    } else {
        scene.add(scene.addMesh(makeTorus(0.9f, 0.3f)), body);
    }
    Node& node = scene.scene.nodes[0];
    node.at = {0.2f, 1.4f, 0};
    node.rotate = {60, 20, 0};
    scene.add(scene.addMesh(makeSphere(0.4f)), body).at = {-1.4f, 0.8f, 0.5f};
    scene.add(scene.addMesh(makePlane(30, 30)), mirror);
    scene.addSun({-0.5f, -1, -0.3f}, 3);
    scene.scene.environment.zenith.rgb = {0.3f, 0.4f, 0.6f};
    scene.scene.environment.horizon.rgb = {0.5f, 0.5f, 0.4f};
    scene.scene.environment.ground.rgb = {0.3f, 0.2f, 0.1f};
    scene.scene.render.bounces = 1;
    scene.scene.render.threshold = 0;
    Camera& camera = scene.scene.cameras[0];
    camera.eye = {0.5f, 3, 5};
    camera.target = {0, -1, 0};
    return scene;
}

TEST_F(MirrorTest, ShowsWhatAMirroredCameraSees) {
    for (const bool field : {false, true})
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend) + (field ? ", field" : ", mesh"));
            test::TestScene scene = thingsOverAMirror(field);
            const ImageRgba8 inMirror = draw(scene, backend);

            // Where the camera sees the mirror itself: all of the rest is set equal.
            PictureRequest request;
            request.width = kWidth;
            request.height = kHeight;
            request.samples = 1;
            request.view = View::kInstance;
            const ImageRgba8 with = test::drawPicture(scene.load(), backend, request);
            scene.scene.nodes.back().visible = false;
            const ImageRgba8 without = test::drawPicture(scene.load(), backend, request);

            Camera& camera = scene.scene.cameras[0];
            camera.eye.y = -camera.eye.y;
            camera.target.y = -camera.target.y;
            camera.up = {0, -1, 0};
            scene.scene.render.bounces = 0;
            const ImageRgba8 mirrored = draw(scene, backend);
            ImageRgba8 expected = inMirror;
            int seen = 0, things = 0;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    if (std::ranges::equal(with.at(x, y), without.at(x, y))) continue;
                    ++seen;
                    std::ranges::copy(mirrored.at(kWidth - 1 - x, y), expected.at(x, y).begin());
                    things += mirrored.at(kWidth - 1 - x, y)[0] > mirrored.at(kWidth - 1 - x, y)[2];
                }
            EXPECT_GT(seen, kWidth * kHeight / 3);
            EXPECT_GT(things, 1500);
            const Comparison comparison = compareImages(inMirror, expected);
            EXPECT_LT(comparison.fractionOver, 0.001) << comparison.pixelsOver << " pixels";
        }
}

TEST_F(MirrorTest, EachBounceShowsOneImageMore) {
    // A glowing ball before a mirror floor and a mirror wall. Its images stand at mirrored places.
    constexpr float kGlow = 0.5f;
    for (const bool field : {false, true})
        for (int bounces = 0; bounces <= 3; ++bounces) {
            SCOPED_TRACE(fmt::format("{} bounces, {}", bounces, field ? "field" : "mesh"));
            test::TestScene scene;
            Material glow;
            glow.baseColor.rgb = glm::vec3(0);
            glow.emission.rgb = glm::vec3(kGlow);
            const int ball = scene.addMaterial(glow), mirror = scene.addMaterial(mirrorMaterial());
            scene
                .add(field ? scene.addField("// bounds[-0.35, -0.35, -0.35, 0.35, 0.35, 0.35]\n"
                                            "float sdf(vec3 p) { return length(p) - 0.3; }")
                           : scene.addMesh(makeSphere(0.3f)),
                     ball)
                .at = {0, 1, 0};
            const int plane = scene.addMesh(makePlane(20, 20));
            scene.add(plane, mirror);
            Node& wall = scene.add(plane, mirror);
            wall.at = {0, 0, -2};
            wall.rotate = {90, 0, 0};
            scene.scene.render.bounces = bounces;
            Camera& camera = scene.scene.cameras[0];
            camera.eye = {0.3f, 2, 5};
            camera.target = {0, 0, -1};
            camera.fov = 60;
            const ImageRgba8 image = draw(scene, Backend::kAuto);
            const auto brightness = [&](const glm::vec3& place) {
                const glm::vec3 way = glm::normalize(place - camera.eye);
                float nearest = -1;
                int value = 0;
                for (int y = 0; y < kHeight; ++y)
                    for (int x = 0; x < kWidth; ++x) {
                        const float near =
                            glm::dot(way, test::pixelRay(camera, kWidth, kHeight, x, y).direction);
                        if (near <= nearest) continue;
                        nearest = near;
                        value = image.at(x, y)[0];
                    }
                return value;
            };
            const auto expectGlow = [&](const glm::vec3& place, int needed) {
                if (bounces >= needed)
                    EXPECT_NEAR(test::linearFromSrgb(brightness(place)), kGlow, 0.01) << needed;
                else
                    EXPECT_LE(brightness(place), 2) << needed;
            };
            expectGlow({0, 1, 0}, 0);
            expectGlow({0, -1, 0}, 1);
            expectGlow({0, 1, -4}, 1);
            expectGlow({0, -1, -4}, 2);
        }
}

}  // namespace
}  // namespace vitrine
