// SPDX-License-Identifier: MIT
// Light through substances of known thickness, lit from behind, against exp(-d / r); the same for
// meshes and fields.
#include <cmath>

#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 32, kHeight = 32, kSamples = 16;
constexpr float kRadius = 0.2f;

class SubstanceTest : public test::GpuTest {
  protected:
    static Material wax(float amount = 1) {
        Material m;
        m.baseColor.rgb = glm::vec3(1);
        m.specular = 0;
        m.roughness = 1;
        m.subsurface = amount;
        m.subsurfaceRadius = kRadius;
        return m;
    }
    /// A wide slab, its front at z = 0, looked at along -z; a sun shines along `travel`.
    static test::TestScene slab(float thickness, bool field, const Material& material,
                                const glm::vec3& travel = {0, 0, 1}) {
        test::TestScene scene;
        const int shape =
            field ? scene.addField(fmt::format("// bounds[-8, -8, {0}, 8, 8, 0.1]\n"
                                               "float sdf(vec3 p) {{\n"
                                               "    vec3 q = abs(p - vec3(0.0, 0.0, {1})) - "
                                               "vec3(7.0, 7.0, {2});\n"
                                               "    return max(q.x, max(q.y, q.z));\n}}\n",
                                               -thickness - 0.1f, -thickness / 2, thickness / 2))
                  : scene.addMesh(makeBox({7, 7, thickness / 2}));
        Node& node = scene.add(shape, scene.addMaterial(material));
        if (!field) node.at = {0, 0, -thickness / 2};
        scene.addSun(travel, 2);
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0, 0, 3};
        camera.target = {0, 0, 0};
        camera.fov = 5;
        return scene;
    }
    static double mean(const test::TestScene& scene, View view = View::kColor,
                       Backend backend = Backend::kAuto, RenderMode mode = RenderMode::kHybrid) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = kSamples;
        request.view = view;
        request.mode = mode;
        const ImageRgba8 image = test::drawPicture(scene.load(), backend, request);
        double sum = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const double v = image.at(x, y)[0];
                sum += view == View::kColor ? test::linearFromSrgb(v) : v / 255;
            }
        return sum / (kWidth * kHeight);
    }
};

TEST_F(SubstanceTest, LetsThroughWhatTheThicknessSays) {
    for (const Backend backend : test::kBackends)
        for (const bool field : {false, true})
            for (const float thickness : {0.02f, 0.1f, 0.2f, 0.5f}) {
                SCOPED_TRACE(test::nameOf(backend) +
                             fmt::format(", field {}, {} m", field, thickness));
                // Straight through: the lobe is 1. 2 W/m2 over pi.
                const double expected = 2 / kPi * std::exp(-thickness / kRadius);
                EXPECT_NEAR(mean(slab(thickness, field, wax()), View::kColor, backend), expected,
                            0.01);
            }
}

TEST_F(SubstanceTest, SlantingLightHasALongerWay) {
    // The ratio of two slabs has no lobe in it.
    const glm::vec3 travel = glm::normalize(glm::vec3(1, 0, 1));
    const double thin = mean(slab(0.05f, false, wax(), travel));
    const double thick = mean(slab(0.15f, false, wax(), travel));
    EXPECT_NEAR(std::log(thin / thick), 0.1 * std::sqrt(2.0) / kRadius, 0.05);
}

TEST_F(SubstanceTest, WhatStandsInTheWayOfTheLightShadowsIt) {
    test::TestScene scene = slab(0.1f, false, wax());
    scene.add(scene.addMesh(makeBox({20, 20, 1}))).at = {0, 0, -4};
    EXPECT_LT(mean(scene), 0.002);
}

TEST_F(SubstanceTest, IsForAllMaterialsByOneSettingAndGoneByNone) {
    test::TestScene scene = slab(0.1f, false, wax(0));
    EXPECT_FALSE(scene.pack().hasSubsurface);
    EXPECT_LT(mean(scene), 0.002);
    scene.scene.render.sssAll = 0.5f;
    EXPECT_TRUE(scene.pack().hasSubsurface);
    const double expected = 0.5 * 2 / kPi * std::exp(-0.1 / kRadius);
    EXPECT_NEAR(mean(scene), expected, 0.01);
    EXPECT_NEAR(mean(scene, View::kColor, Backend::kAuto, RenderMode::kReference), expected, 0.01);
}

TEST_F(SubstanceTest, AMetalLetsNothingThrough) {
    Material metal = wax();
    metal.metallic = 1;
    EXPECT_LT(mean(slab(0.02f, false, metal)), 0.002);
}

TEST_F(SubstanceTest, TheViewShowsThickness) {
    for (const bool field : {false, true})
        for (const float thickness : {0.05f, 0.2f}) {
            SCOPED_TRACE(fmt::format("field {}, {} m", field, thickness));
            test::TestScene scene = slab(thickness, field, wax(0));
            // What stands close behind is not part of it.
            scene.add(scene.addMesh(makeBox({7, 7, 0.5f}))).at = {0, 0, -thickness - 0.51f};
            EXPECT_NEAR(mean(scene, View::kThickness), std::exp(-thickness / kRadius), 0.01);
        }
}

}  // namespace
}  // namespace vitrine
