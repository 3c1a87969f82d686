// SPDX-License-Identifier: MIT
// Hybrid against reference where both follow the same light, and normals that are bent too far.
//
// Round bodies that do not see each other get light from lamps and sky alone, which both modes
// count in full: the means of the picture's blocks of 8 x 8 pixels agree within 0.012 of light
// around 0.3, five times the noise left by 64 samples. The eighth bounce more or less changes
// nothing here.
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 96, kHeight = 64;

class ModeTest : public test::GpuTest {};

ImageRgba8 draw(const test::TestScene& scene, RenderMode mode, int samples) {
    PictureRequest request;
    request.width = kWidth;
    request.height = kHeight;
    request.samples = samples;
    request.mode = mode;
    return test::drawPicture(scene.load(), Backend::kAuto, request);
}

double blockMean(const ImageRgba8& image, int left, int top) {
    double sum = 0;
    for (int y = top; y < top + 8; ++y)
        for (int x = left; x < left + 8; ++x)
            for (int c = 0; c < 3; ++c) sum += test::linearFromSrgb(image.at(x, y)[c]);
    return sum / (8 * 8 * 3);
}

double worstBlock(const ImageRgba8& a, const ImageRgba8& b) {
    double worst = 0;
    for (int y = 0; y < kHeight; y += 8)
        for (int x = 0; x < kWidth; x += 8)
            worst = std::max(worst, std::abs(blockMean(a, x, y) - blockMean(b, x, y)));
    return worst;
}

TEST_F(ModeTest, AgreeAboutBodiesThatDoNotSeeEachOther) {
    Material matt, metal, varnished, cloth;
    matt.baseColor.rgb = {0.7f, 0.4f, 0.2f};
    matt.roughness = 0.8f;
    metal.baseColor.rgb = {0.9f, 0.8f, 0.6f};
    metal.metallic = 1;
    metal.roughness = 0.4f;
    varnished = matt;
    varnished.clearcoat = 1;
    varnished.clearcoatRoughness = 0.05f;
    cloth = matt;
    cloth.sheenColor.rgb = {0.4f, 0.5f, 0.8f};
    cloth.sheenRoughness = 0.7f;
    for (const Material& material : {matt, metal, varnished, cloth}) {
        test::TestScene scene;
        scene.add(scene.addMesh(makeSphere(1, 96)), scene.addMaterial(material));
        scene.addSun({-0.5f, -1, -0.7f}, 1);
        scene.scene.environment.zenith.rgb = {0.5f, 0.6f, 0.7f};
        scene.scene.environment.horizon.rgb = {0.3f, 0.3f, 0.3f};
        scene.scene.environment.ground.rgb = {0.1f, 0.15f, 0.1f};
        scene.scene.render.ao = 1;
        scene.scene.render.bounces = 2;
        scene.scene.render.threshold = 0;
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0.5f, 1, 3.4f};
        camera.target = {0, 0, 0};
        // Sheen is spread evenly by the ambient term, which its rim shows.
        const double allowed = material.sheenColor.rgb.x > 0 ? 0.03 : 0.012;
        EXPECT_LT(worstBlock(draw(scene, RenderMode::kHybrid, 64),
                             draw(scene, RenderMode::kReference, 64)),
                  allowed);
    }
}

TEST_F(ModeTest, MirrorsAgreeAboutEverything) {
    test::TestScene scene;
    Material mirror, glow;
    mirror.baseColor.rgb = {0.9f, 0.9f, 0.7f};
    mirror.metallic = 1;
    mirror.roughness = 0;
    glow.baseColor.rgb = glm::vec3(0);
    glow.specular = 0;
    glow.emission.rgb = {0.6f, 0.2f, 0.1f};
    const int ball = scene.addMesh(makeSphere(0.5f, 64));
    scene.add(ball, scene.addMaterial(mirror)).at = {-0.6f, 0.5f, 0};
    scene.add(ball, scene.addMaterial(glow)).at = {0.6f, 0.5f, 0.3f};
    scene.add(scene.addMesh(makePlane(4, 4)), 0);
    scene.addSun({-0.5f, -1, -0.7f}, 1);
    scene.setEnvironment(0.3f);
    scene.scene.render.bounces = 3;
    scene.scene.render.threshold = 0;
    scene.scene.cameras[0].eye = {0.5f, 1.2f, 4};
    scene.scene.cameras[0].target = {0, 0.4f, 0};
    const ImageRgba8 hybrid = draw(scene, RenderMode::kHybrid, 16);
    EXPECT_LT(worstBlock(hybrid, draw(scene, RenderMode::kReference, 16)), 0.004);
}

TEST_F(ModeTest, TheReferenceSeesLightThatBouncesOffWalls) {
    // A white room with nothing but a lamp: what the hybrid leaves black, the reference lights.
    test::TestScene scene;
    Material white;
    white.baseColor.rgb = glm::vec3(0.8f);
    white.roughness = 1;
    scene.add(scene.addMesh(makeBox({2, 2, 2})), scene.addMaterial(white));
    scene.add(scene.addMesh(makeBox({0.6f, 0.02f, 0.6f})), 0).at = {0, 0.5f, 0};
    Light lamp;
    lamp.type = LightType::kPoint;
    lamp.at = {0, 1, 0};
    lamp.intensity = 3;
    scene.scene.lights.push_back(lamp);
    scene.scene.render.bounces = 4;
    scene.scene.cameras[0].eye = {0, -0.5f, 1.9f};
    scene.scene.cameras[0].target = {0, -2, 0};
    const double hybrid = blockMean(draw(scene, RenderMode::kHybrid, 4), 40, 28);
    const double reference = blockMean(draw(scene, RenderMode::kReference, 64), 40, 28);
    EXPECT_LT(hybrid, 0.01);
    EXPECT_GT(reference, 0.02);
}

/// Normals that lean to one side by 80 degrees.
Material leaning() {
    Material m;
    auto image = std::make_shared<ImageRgba8>(4, 4);
    for (size_t i = 0; i < image->pixels.size(); i += 4) {
        image->pixels[i] = 253;
        image->pixels[i + 1] = 128;
        image->pixels[i + 2] = 150;
        image->pixels[i + 3] = 255;
    }
    m.normalTexture.image = image;
    return m;
}

TEST_F(ModeTest, BentNormalsLeakNoLight) {
    // From below the plane comes nothing, though the bent normal faces the lamp.
    test::TestScene scene;
    Material matt = leaning();
    matt.roughness = 0.5f;
    matt.clearcoat = 1;
    scene.add(scene.addMesh(makePlane(5, 5)), scene.addMaterial(matt));
    scene.addSun({-1, 0.05f, 0}, 5);
    scene.scene.cameras[0].eye = {1, 4, 3};
    scene.scene.cameras[0].target = {0, 0, 0};
    EXPECT_LT(blockMean(draw(scene, RenderMode::kHybrid, 1), 40, 28), 0.001);  // the dither
    // From above it does.
    scene.scene.lights[0].direction = {-1, -0.05f, 0};
    EXPECT_GT(blockMean(draw(scene, RenderMode::kHybrid, 1), 40, 28), 0.1);
}

TEST_F(ModeTest, BentMirrorsSeeNothingOfTheirInside) {
    test::TestScene scene;
    Material mirror = leaning();
    mirror.baseColor.rgb = glm::vec3(1);
    mirror.metallic = 1;
    mirror.roughness = 0;
    scene.add(scene.addMesh(makePlane(50, 50)), scene.addMaterial(mirror));
    scene.scene.environment.zenith.rgb = glm::vec3(0.5f);
    scene.scene.environment.horizon.rgb = glm::vec3(0.5f);
    scene.scene.environment.ground.rgb = glm::vec3(0);
    scene.scene.render.bounces = 1;
    scene.scene.cameras[0].eye = {1, 4, 3};
    scene.scene.cameras[0].target = {0, 0, 0};
    for (const float roughness : {0.0f, 0.2f}) {
        scene.scene.materials[0].roughness = roughness;
        const double seen = blockMean(draw(scene, RenderMode::kHybrid, 32), 40, 28);
        EXPECT_NEAR(seen, 0.5, roughness > 0 ? 0.06 : 0.003) << roughness;
    }
}

}  // namespace
}  // namespace vitrine
