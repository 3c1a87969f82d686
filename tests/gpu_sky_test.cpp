// SPDX-License-Identifier: MIT
// Pictures of all directions as light, against integrals on paper and against a sun.
//
// Tolerances are on means over hundreds of pixels of 64 samples. Noise of such a mean is below 0.5
// % (seen over five seeds); what the tests allow beyond is named at each.
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 48, kHeight = 32;

ImageRgba32f paintedSky(int width, int height,
                        const std::function<float(const glm::vec3&)>& radiance) {
    ImageRgba32f picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float value =
                radiance(skyDirection((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                      (static_cast<float>(y) + 0.5f) / static_cast<float>(height)));
            for (size_t c = 0; c < 4; ++c) picture.at(x, y)[c] = c == 3 ? 1 : value;
        }
    return picture;
}

/// The integral over the hemisphere above `normal` of the picture times the cosine.
double irradiance(const ImageRgba32f& picture, const glm::vec3& normal, float rotation = 0) {
    double sum = 0;
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(rotation), glm::vec3(0, 1, 0));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 inPicture =
                skyDirection((static_cast<float>(x) + 0.5f) / static_cast<float>(picture.width),
                             (static_cast<float>(y) + 0.5f) / static_cast<float>(picture.height));
            const glm::vec3 d(turn * glm::vec4(inPicture, 0));
            const double angle = 2.0 * kPi * kPi * std::sqrt(1 - d.y * d.y) /
                                 static_cast<double>(picture.pixelCount());
            sum += picture.at(x, y)[0] * std::max(0.0f, glm::dot(d, normal)) * angle;
        }
    return sum;
}

class SkyTest : public test::GpuTest {
  protected:
    static constexpr float kAlbedo = 0.8f;

    static Material matt() {
        Material m;
        m.baseColor.rgb = glm::vec3(kAlbedo);
        m.roughness = 1;
        m.specular = 0;
        return m;
    }
    static ImageRgba8 draw(const test::TestScene& scene, RenderMode mode, int samples = 64,
                           Backend backend = Backend::kAuto) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = samples;
        request.mode = mode;
        return test::drawPicture(scene.load(), backend, request);
    }
    static double mean(const ImageRgba8& image, int x0 = 0, int x1 = kWidth, int y0 = 0,
                       int y1 = kHeight) {
        double sum = 0;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) sum += test::linearFromSrgb(image.at(x, y)[0]);
        return sum / ((x1 - x0) * (y1 - y0));
    }
    /// A plane with this normal that fills the picture.
    static test::TestScene wall(const glm::vec3& rotate, const glm::vec3& normal,
                                const Material& material) {
        test::TestScene scene;
        scene.add(scene.addMesh(makePlane(50, 50)), scene.addMaterial(material)).rotate = rotate;
        scene.scene.cameras[0].eye = 3.0f * glm::normalize(normal + glm::vec3(0.1f, 0.05f, 0.2f));
        scene.scene.cameras[0].target = {0, 0, 0};
        scene.scene.render.bounces = 1;
        return scene;
    }
};

TEST_F(SkyTest, MattWallsShowTheIntegralOfThePicture) {
    // Even light from below and above, a soft glow and a small lamp, none of them at an axis.
    const glm::vec3 glow = glm::normalize(glm::vec3(0.7f, 0.5f, 0.4f));
    const glm::vec3 lamp = glm::normalize(glm::vec3(0.3f, 0.6f, -0.5f));
    const ImageRgba32f picture = paintedSky(128, 64, [&](const glm::vec3& d) {
        return 0.15f + 0.1f * d.y + 0.6f * std::pow(std::max(0.0f, glm::dot(d, glow)), 8.0f) +
               (glm::dot(d, lamp) > 0.995f ? 20.0f : 0.0f);
    });
    struct Wall {
        glm::vec3 rotate, normal;
    };
    for (const Wall& w :
         {Wall{{0, 0, 0}, {0, 1, 0}}, Wall{{90, 0, 0}, {0, 0, 1}}, Wall{{0, 0, -90}, {1, 0, 0}}})
        for (const float rotation : {0.0f, 110.0f})
            for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference})
                for (const Backend backend : test::kBackends) {
                    if (backend == Backend::kCompute && rotation == 0) continue;
                    SCOPED_TRACE(fmt::format("normal {} {} {}, rotation {}, mode {}", w.normal.x,
                                             w.normal.y, w.normal.z, rotation,
                                             static_cast<int>(mode)));
                    test::TestScene scene = wall(w.rotate, w.normal, matt());
                    scene.scene.environment.rotation = rotation;
                    scene.setSky(picture);
                    const double expected = kAlbedo / kPi * irradiance(picture, w.normal, rotation);
                    // 2 %: ambient light is looked up in smaller versions of the picture.
                    EXPECT_NEAR(mean(draw(scene, mode, 64, backend)) / expected, 1, 0.02);
                }
}

TEST_F(SkyTest, WhiteFurnace) {
    const ImageRgba32f picture = paintedSky(32, 16, [](const glm::vec3&) { return 0.5f; });
    for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference})
        for (const float metallic : {0.0f, 1.0f})
            for (const float roughness : {0.0f, 0.4f, 1.0f}) {
                SCOPED_TRACE(fmt::format("mode {}, metallic {}, roughness {}",
                                         static_cast<int>(mode), metallic, roughness));
                Material white;
                white.baseColor.rgb = glm::vec3(1);
                white.metallic = metallic;
                white.roughness = roughness;
                test::TestScene scene = wall({0, 0, 0}, {0, 1, 0}, white);
                scene.setSky(picture);
                EXPECT_NEAR(mean(draw(scene, mode, 32)) / 0.5, 1, 0.02);
            }
}

TEST_F(SkyTest, OneBrightTexelIsASun) {
    // The same light from a texel and from a sun: as bright, and with the shadow at the same place.
    // The texel is 2.8 degrees wide, so that a strip along the shadow's edge does not count.
    ImageRgba32f picture(128, 64);
    constexpr int kX = 70, kY = 12;
    picture.at(kX, kY)[0] = picture.at(kX, kY)[1] = picture.at(kX, kY)[2] = 600;
    const glm::vec3 toSun = skyDirection((kX + 0.5f) / 128, (kY + 0.5f) / 64);
    const double height = std::cos(kPi * kY / 64.0) - std::cos(kPi * (kY + 1) / 64.0);
    const auto power = static_cast<float>(600 * height * 2 * kPi / 128);
    for (const float roughness : {1.0f, 0.5f})
        for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference}) {
            SCOPED_TRACE(fmt::format("roughness {}, mode {}", roughness, static_cast<int>(mode)));
            Material material = matt();
            material.roughness = roughness;
            material.specular = roughness < 1 ? 1.0f : 0.0f;
            test::TestScene bySky, bySun;
            for (test::TestScene* scene : {&bySky, &bySun}) {
                const int m = scene->addMaterial(material);
                scene->add(scene->addMesh(makePlane(50, 50)), m);
                scene->add(scene->addMesh(makeSphere(0.5f)), m).at = {0, 1.2f, 0};
                scene->scene.cameras[0].eye = {0.5f, 4, 3};
                scene->scene.cameras[0].target = {-0.6f, 0, 0};
                scene->scene.render.bounces = 1;
            }
            bySky.setSky(picture);
            bySun.addSun(-toSun, power);
            const ImageRgba8 a = draw(bySky, mode), b = draw(bySun, mode, 16);
            int dark = 0, differ = 0;
            double sumA = 0, sumB = 0;
            for (int y = 1; y < kHeight - 1; ++y)
                for (int x = 1; x < kWidth - 1; ++x) {
                    int least = 255, most = 0;
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx) {
                            least = std::min<int>(least, b.at(x + dx, y + dy)[0]);
                            most = std::max<int>(most, b.at(x + dx, y + dy)[0]);
                        }
                    if (most - least > 25) continue;
                    const int va = a.at(x, y)[0], vb = b.at(x, y)[0];
                    dark += vb < 20;
                    sumA += test::linearFromSrgb(va);
                    sumB += test::linearFromSrgb(vb);
                    differ += std::abs(va - vb) > 20;
                }
            EXPECT_GT(dark, 5);
            EXPECT_NEAR(sumA / sumB, 1, 0.02);
            EXPECT_LT(differ, 4);
        }
}

TEST_F(SkyTest, BouncesAndProbesShareTheLightOfALamp) {
    // A lamp in the picture, seen in a glossy floor. Without a bounce only the probes find it; with
    // one, the two share it by their weights, and the sum must stay.
    const glm::vec3 lamp = glm::normalize(glm::vec3(0.2f, 0.8f, -0.55f));
    const ImageRgba32f picture = paintedSky(
        128, 64, [&](const glm::vec3& d) { return glm::dot(d, lamp) > 0.99f ? 30.0f : 0.0f; });
    for (const float roughness : {0.3f, 0.6f})
        for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference}) {
            SCOPED_TRACE(fmt::format("roughness {}, mode {}", roughness, static_cast<int>(mode)));
            Material metal;
            metal.baseColor.rgb = glm::vec3(0.3f);
            metal.metallic = 1;
            metal.roughness = roughness;
            test::TestScene scene = wall({0, 0, 0}, {0, 1, 0}, metal);
            scene.scene.cameras[0].eye = {-0.8f, 3, 2};
            scene.setSky(picture);
            const double shared = mean(draw(scene, mode));
            scene.scene.render.bounces = 0;
            const double probes = mean(draw(scene, mode));
            // In hybrid mode the part of the lamp below the limit is found by bounces alone.
            const double below = kBrightMultiple * 0.005;
            EXPECT_NEAR(probes / shared, mode == RenderMode::kHybrid ? 1 - below : 1, 0.03);
            EXPECT_GT(probes, 0.02);
        }
}

}  // namespace
}  // namespace vitrine
