// SPDX-License-Identifier: MIT
// Lights with a size: what arrives, where their half shadows lie, and that chosen directions and
// bounces share their light.
//
// Means over a thousand pixels of 64 samples; tolerances are named where they stand.
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 48, kHeight = 32;

class SizedLightTest : public test::GpuTest {
  protected:
    static ImageRgba8 draw(const test::TestScene& scene, RenderMode mode = RenderMode::kHybrid,
                           int samples = 64, Backend backend = Backend::kAuto) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = samples;
        request.mode = mode;
        return test::drawPicture(scene.load(), backend, request);
    }
    static double mean(const ImageRgba8& image, int x0 = 0, int x1 = kWidth) {
        double sum = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = x0; x < x1; ++x) sum += test::linearFromSrgb(image.at(x, y)[0]);
        return sum / ((x1 - x0) * kHeight);
    }
    /// A floor that fills the picture, looked at nearly from above; 0.02 m a pixel in its middle.
    static test::TestScene floor(const Material& material) {
        test::TestScene scene;
        scene.add(scene.addMesh(makePlane(50, 50)), scene.addMaterial(material));
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0, 1.0f, 0.05f};
        camera.target = {0, 0, 0};
        camera.fov = 35;
        scene.scene.render.bounces = 1;
        return scene;
    }
    static Material matt() {
        Material m;
        m.baseColor.rgb = glm::vec3(0.8f);
        m.roughness = 1;
        m.specular = 0;
        return m;
    }
};

Light lampAbove(LightType type, float size) {
    Light lamp;
    lamp.type = type;
    lamp.at = {0, 2, 0};
    lamp.direction = {0, -1, 0};
    lamp.intensity = 6;
    lamp.outerAngle = 80;
    lamp.innerAngle = 70;
    if (type == LightType::kRect)
        lamp.size = glm::vec3(size);
    else
        lamp.radius = size;
    return lamp;
}

TEST_F(SizedLightTest, GivesWhatAPointGivesFromAfar) {
    for (const Backend backend : test::kBackends)
        for (const LightType type :
             {LightType::kPoint, LightType::kSphere, LightType::kSpot, LightType::kRect}) {
            SCOPED_TRACE(test::nameOf(backend) + fmt::format(", {}", static_cast<int>(type)));
            test::TestScene hard = floor(matt()), soft = floor(matt());
            const LightType twin = type == LightType::kRect ? LightType::kPoint : type;
            hard.scene.lights.push_back(lampAbove(twin, 0));
            soft.scene.lights.push_back(lampAbove(type, 0.1f));
            // A sphere sends as much as its centre to a surface that sees all of it; a rect 1 %
            // less.
            EXPECT_NEAR(mean(draw(soft, RenderMode::kHybrid, 32, backend)) /
                            mean(draw(hard, RenderMode::kHybrid, 4, backend)),
                        1, 0.015);
        }
}

TEST_F(SizedLightTest, HalfShadowsAreAsWideAsOnPaper) {
    // Half of the sky is covered to the edge x = 0 at a height of 1: the shadow runs from all to
    // nothing over the width that the light has in the mirror image of a pinhole.
    struct Case {
        Light light;
        double halfWidth;
    };
    Light sun;
    sun.direction = {0, -1, 0};
    sun.radius = 8;
    for (const Case& c :
         {Case{sun, std::tan(glm::radians(8.0))}, Case{lampAbove(LightType::kSphere, 0.15f), 0.15},
          Case{lampAbove(LightType::kRect, 0.3f), 0.15}}) {
        SCOPED_TRACE(fmt::format("light {}", static_cast<int>(c.light.type)));
        test::TestScene scene = floor(matt());
        Node& cover = scene.add(scene.addMesh(makePlane(20, 20)));
        cover.at = {20, 1, 0};
        // Under the cover's height, so that the camera sees the floor.
        scene.scene.cameras[0].eye = {0, 0.98f, 0.05f};
        scene.scene.lights.push_back(c.light);
        test::TestScene open = floor(matt());
        open.scene.cameras[0].eye = scene.scene.cameras[0].eye;
        open.scene.lights.push_back(c.light);
        const ImageRgba8 a = draw(scene, RenderMode::kHybrid, 128), b = draw(open);
        for (int x = 0; x < kWidth; ++x) {
            const Ray ray = test::pixelRay(scene.scene.cameras[0], kWidth, kHeight, x, kHeight / 2);
            const double p = ray.origin.x - ray.origin.y / ray.direction.y * ray.direction.x;
            // The part of the light left of the edge, as seen from there.
            const double s = std::clamp(-p / c.halfWidth, -1.0, 1.0);
            const double disc = 0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / kPi;
            const double expected = c.light.type == LightType::kRect ? 0.5 + 0.5 * s : disc;
            // Noise of the mean of 32 pixels of 128 samples is 0.008 at most.
            EXPECT_NEAR(mean(a, x, x + 1) / mean(b, x, x + 1), expected, 0.04) << "at " << p;
        }
    }
}

TEST_F(SizedLightTest, BouncesAndChosenDirectionsShareItsLight) {
    Light sun;
    sun.direction = {0.1f, -1, 0.05f};
    sun.radius = 6;
    sun.intensity = 0.5f;
    for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference})
        for (const Light& light :
             {sun, lampAbove(LightType::kSphere, 0.25f), lampAbove(LightType::kPoint, 0.25f),
              lampAbove(LightType::kRect, 0.5f)})
            for (const float roughness : {0.35f, 0.6f}) {
                SCOPED_TRACE(fmt::format("mode {}, light {}, roughness {}", static_cast<int>(mode),
                                         static_cast<int>(light.type), roughness));
                Material metal;
                metal.baseColor.rgb = glm::vec3(light.type == LightType::kSun ? 0.3f : 0.1f);
                metal.metallic = 1;
                metal.roughness = roughness;
                test::TestScene scene = floor(metal);
                scene.scene.lights.push_back(light);
                const double shared = mean(draw(scene, mode));
                scene.scene.render.bounces = 0;
                const double chosen = mean(draw(scene, mode));
                EXPECT_NEAR(chosen / shared, 1, 0.025);
                EXPECT_GT(chosen, 0.02);
            }
}

TEST_F(SizedLightTest, MirrorsShowItAndCamerasOnlyLampsThatAreThere) {
    for (const auto& [type, seen] : {std::pair(LightType::kSphere, true),
                                     {LightType::kRect, true},
                                     {LightType::kPoint, false}}) {
        SCOPED_TRACE(fmt::format("light {}", static_cast<int>(type)));
        Material mirror;
        mirror.baseColor.rgb = glm::vec3(1);
        mirror.metallic = 1;
        mirror.roughness = 0;
        test::TestScene scene = floor(mirror);
        Light lamp = lampAbove(type, 0.4f);
        lamp.intensity = type == LightType::kRect ? 0.08f : 0.25f;
        scene.scene.lights.push_back(lamp);
        // Radiance: of a rect over its area, of a sphere over that of its disc.
        const double expected = type == LightType::kRect ? 0.08 / 0.16 : 0.25 / (kPi * 0.4 * 0.4);
        const auto centre = [&] {
            return test::linearFromSrgb(
                draw(scene, RenderMode::kHybrid, 1).at(kWidth / 2, kHeight / 2)[0]);
        };
        EXPECT_NEAR(centre(), expected, 0.01);
        scene.scene.cameras[0].eye = {0, 0.5f, 0};
        scene.scene.cameras[0].target = {0, 2, 0.01f};
        EXPECT_NEAR(centre(), seen ? expected : 0, 0.01);
    }
}

}  // namespace
}  // namespace vitrine
