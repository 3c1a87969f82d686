// SPDX-License-Identifier: MIT
// The layers of an EXR: against what is known of the scene, and against the picture.
#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 96, kHeight = 64;
constexpr float kWallAway = 5;

class LayersTest : public test::GpuTest {};

/// A wall square to the view axis, before it a ball as a field. Nothing beside them.
LoadedScene wallAndBall(int ssaa) {
    test::TestScene scene;
    const int wall = scene.addMesh(makePlane(2, 2));
    const int ball = scene.addField(
        "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return length(p) - 1.0; }\n");
    Material red, blue;
    red.baseColor.rgb = {0.6f, 0.2f, 0.1f};
    blue.baseColor.rgb = {0.1f, 0.2f, 0.7f};
    blue.emission.rgb = {0, 3.5f, 0};
    const int first = scene.addMaterial(red), second = scene.addMaterial(blue);
    Node& node = scene.add(wall, first);
    node.at = {0, 0, -kWallAway};
    node.rotate = {90, 0, 0};
    scene.add(ball, second).at = {0, 0, -3};
    scene.addSun({-0.3f, -0.5f, -1}, 2);
    scene.setEnvironment(0.2f);
    Camera& camera = scene.scene.cameras[0];
    camera.eye = {0, 0, 0};
    camera.target = {0, 0, -1};
    camera.fov = 50;
    scene.scene.render.ssaa = ssaa;
    return scene.load();
}

PictureRequest request() {
    PictureRequest r;
    r.width = kWidth;
    r.height = kHeight;
    r.samples = 1;
    return r;
}

LayerImages drawLayers(const LoadedScene& loaded, Backend backend, PictureRequest r = request()) {
    Renderer renderer(loaded, backend, false);
    return renderer.drawLayers(r, nullptr);
}

}  // namespace

TEST_F(LayersTest, SayWhatIsThere) {
    const LoadedScene loaded = wallAndBall(1);
    for (const Backend backend : test::kBackends)
        for (const Primary primary : {Primary::kRaster, Primary::kTrace}) {
            SCOPED_TRACE(test::nameOf(backend) + (primary == Primary::kRaster ? " raster" : ""));
            PictureRequest r = request();
            r.primary = primary;
            const LayerImages layers = drawLayers(loaded, backend, r);
            std::array<int, 3> seen{};
            const std::array materials{layers.ids.at(26, 10)[2],
                                       layers.ids.at(kWidth / 2, kHeight / 2)[2]};
            EXPECT_NE(materials[0], materials[1]);
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    const auto normal = layers.normal.at(x, y);
                    const glm::vec3 n(normal[0], normal[1], normal[2]);
                    const float depth = layers.depth.at(x, y)[0];
                    const auto id = layers.ids.at(x, y);
                    if (id[0] == kNoId) {
                        ASSERT_EQ(depth, kNoDepth);
                        ASSERT_EQ(n, glm::vec3(0));
                        ASSERT_EQ(layers.albedo.at(x, y)[0], 0);
                        ++seen[0];
                    } else if (id[0] == 0) {
                        // Along the axis, not along the ray.
                        ASSERT_NEAR(depth, kWallAway, 1e-4f) << x << ' ' << y;
                        ASSERT_LT(id[1], 2u);
                        ASSERT_NEAR(n.z, 1, 1e-5f);
                        ASSERT_NEAR(layers.albedo.at(x, y)[0], 0.6f, 1e-6f);
                        ++seen[1];
                    } else {
                        ASSERT_EQ(id[0], 1u);
                        const Ray ray =
                            test::pixelRay(loaded.scene.cameras[0], kWidth, kHeight, x, y);
                        const glm::vec3 p = ray.direction * (depth / -ray.direction.z);
                        const glm::vec3 radial = p - glm::vec3(0, 0, -3);
                        ASSERT_NEAR(glm::length(radial), 1, 0.01f) << x << ' ' << y;
                        ASSERT_GT(glm::dot(n, radial), 0.99f);
                        ASSERT_NEAR(layers.albedo.at(x, y)[2], 0.7f, 1e-6f);
                        ++seen[2];
                    }
                    if (id[0] != kNoId) {
                        ASSERT_EQ(id[2], materials[id[0]]);
                    }
                }
            for (const int count : seen) EXPECT_GT(count, 500);
        }
}

TEST_F(LayersTest, OnlyWhatCanBeAveragedIs) {
    const LayerImages layers = drawLayers(wallAndBall(3), Backend::kFragment);
    int mixed = 0;
    for (size_t i = 0; i < layers.depth.pixels.size(); ++i) {
        const float depth = layers.depth.pixels[i];
        EXPECT_TRUE(depth == kNoDepth || (depth > 1.9f && depth < 5.001f)) << depth;
        EXPECT_TRUE((depth == kNoDepth) == (layers.ids.pixels[3 * i] == kNoId));
        const float* n = &layers.normal.pixels[3 * i];
        const float length = glm::length(glm::vec3(n[0], n[1], n[2]));
        EXPECT_TRUE(length == 0 || std::abs(length - 1) < 1e-4f) << length;
        const float red = layers.albedo.pixels[3 * i];
        if (red > 0.001f && std::abs(red - 0.6f) > 0.001f && std::abs(red - 0.1f) > 0.001f) ++mixed;
    }
    EXPECT_GT(mixed, 100) << "edges of the albedo are smooth";
}

TEST_F(LayersTest, LightIsThePictureBeforeTheToneMap) {
    for (const int ssaa : {1, 2}) {
        const LoadedScene loaded = wallAndBall(ssaa);
        const LayerImages layers = drawLayers(loaded, Backend::kFragment);
        const ImageRgba8 picture = test::drawPicture(loaded, Backend::kFragment, request());
        // The picture is dithered by up to one step.
        const Comparison c = compareImages(srgbFromLinear(layers.light), picture, 1);
        EXPECT_EQ(c.pixelsOver, 0u);
        EXPECT_GT(*std::max_element(layers.light.pixels.begin(), layers.light.pixels.end()), 3.4f)
            << "light brighter than a screen is kept";
    }
}

}  // namespace vitrine
