// SPDX-License-Identifier: MIT
// What lets rays pass: holes, veils and backs that are not seen. By single rays, where a texel says
// what they must find, and by pictures of both finders, which must agree as in gpu_raster_test.
#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr double kMostPixels = 0.001;

class AlphaTest : public test::GpuTest {};

/// Eight by eight texels, each a hole or not.
std::shared_ptr<ImageRgba8> leaf() {
    std::mt19937 random(11);
    auto image = std::make_shared<ImageRgba8>(8, 8);
    for (size_t i = 0; i < image->pixels.size(); ++i)
        image->pixels[i] = i % 4 != 3 ? 200 : random() % 2 == 0 ? 0 : 255;
    return image;
}

Material masked(const std::shared_ptr<ImageRgba8>& image) {
    Material m;
    m.baseColorTexture.image = image;
    m.alphaMode = AlphaMode::kMask;
    return m;
}

PictureRequest request(Primary primary, int samples = 1) {
    PictureRequest r;
    r.width = 240;
    r.height = 150;
    r.samples = samples;
    r.primary = primary;
    return r;
}

void expectFindersAgree(const LoadedScene& loaded, double mostPixels = kMostPixels) {
    const auto draw = [&](Primary primary, Backend backend) {
        return test::drawPicture(loaded, backend, request(primary, 2));
    };
    const ImageRgba8 trace = draw(Primary::kTrace, Backend::kFragment);
    EXPECT_LT(compareImages(draw(Primary::kRaster, Backend::kFragment), trace).fractionOver,
              mostPixels);
    EXPECT_LT(compareImages(draw(Primary::kTrace, Backend::kCompute), trace).fractionOver,
              mostPixels);
}

double meanOf(const ImageRgba8& image) {
    double sum = 0;
    int count = 0;
    for (int y = image.height / 3; y < 2 * image.height / 3; ++y)
        for (int x = image.width / 3; x < 2 * image.width / 3; ++x, ++count)
            sum += test::linearFromSrgb(image.at(x, y)[0]);
    return sum / count;
}

TEST_F(AlphaTest, RaysPassHolesAndNothingElse) {
    const auto image = leaf();
    test::TestScene scene;
    scene.add(scene.addMesh(makePlane(1, 1)), scene.addMaterial(masked(image)));
    const PackedScene packed = scene.pack();
    std::vector<QueryRay> rays;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            rays.push_back({{-0.875f + 0.25f * static_cast<float>(x), 1,
                             -0.875f + 0.25f * static_cast<float>(y)},
                            0,
                            {0, -1, 0}});
    for (const Backend backend : test::kBackends) {
        RayQuery query(context(), packed, backend);
        const auto closest = query.closest(rays), any = query.any(rays);
        for (size_t i = 0; i < rays.size(); ++i) {
            const bool solid = image->pixels[4 * i + 3] > 127;
            EXPECT_EQ(record::isSurface(closest[i]), solid) << i;
            EXPECT_EQ(record::isSurface(any[i]), solid) << i;
        }
    }
}

TEST_F(AlphaTest, LeavesLookTheSameToBothFinders) {
    test::TestScene scene;
    const int plane = scene.addMesh(makePlane(1, 1));
    const int leaves = scene.addMaterial(masked(leaf()));
    Material mirror;
    mirror.baseColor.rgb = glm::vec3(0.9f);
    mirror.metallic = 1;
    mirror.roughness = 0;
    scene.add(scene.addMesh(makePlane(5, 5)), scene.addMaterial(mirror));
    for (int i = 0; i < 5; ++i) {
        Node& node = scene.add(plane, leaves);
        node.at = {0.3f * static_cast<float>(i) - 0.6f, 0.8f, 0.4f * static_cast<float>(i) - 1};
        node.rotate = {70 + 9 * static_cast<float>(i), 20 * static_cast<float>(i), 10};
        if (i % 2 == 1) node.scale = {-1, 1, 1};
    }
    scene
        .add(scene.addField("// bounds[-0.5, -0.5, -0.5, 0.5, 0.5, 0.5]\n"
                            "float sdf(vec3 p) { return length(p) - 0.45; }\n"))
        .at = {0.2f, 0.6f, 0};
    scene.addSun({-0.5f, -1, -0.4f}, 3);
    scene.setEnvironment(0.3f);
    Camera& camera = scene.scene.cameras[0];
    camera.eye = {0.5f, 1.4f, 4};
    camera.target = {0, 0.6f, 0};
    expectFindersAgree(scene.load());
}

TEST_F(AlphaTest, VeilsLetTheirShareOfLightPass) {
    constexpr float kOpacity = 0.3f;
    for (const bool field : {false, true}) {
        SCOPED_TRACE(field ? "field" : "mesh");
        test::TestScene scene;
        Material veil;
        veil.baseColor.rgb = glm::vec3(0);
        veil.specular = 0;
        veil.emission.rgb = glm::vec3(1);
        veil.opacity = kOpacity;
        veil.alphaMode = AlphaMode::kBlend;
        // From either finder's point of view: a sheet met once, a slab met twice.
        scene.add(field ? scene.addField("// bounds[-3, -3, -0.15, 3, 3, 0.15]\n"
                                         "float sdf(vec3 p) { return abs(p.z) - 0.1; }")
                        : scene.addMesh(makeBox({3, 3, 0.1f})),
                  scene.addMaterial(veil));
        scene.setEnvironment(0.2f);
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0, 0, 4};
        camera.target = {0, 0, 0};
        for (const Primary primary : {Primary::kRaster, Primary::kTrace}) {
            const double mean =
                meanOf(test::drawPicture(scene.load(), Backend::kAuto, request(primary, 16)));
            // A field's two surfaces are one part and share their random number.
            const double through = field ? 1 - kOpacity : (1 - kOpacity) * (1 - kOpacity);
            EXPECT_NEAR(mean, 1 - through + 0.2 * through, 0.01);
        }
        // On the edge between two triangles the finders may choose one each, with its own number.
        expectFindersAgree(scene.load(), 3 * kMostPixels);
    }
}

TEST_F(AlphaTest, BacksAreNotSeenButThrowShadows) {
    for (const float mirrored : {1.0f, -1.0f}) {
        test::TestScene scene;
        Material single;
        single.doubleSided = false;
        const int ball = scene.addMesh(makeSphere(1, 32)), material = scene.addMaterial(single);
        scene.add(ball, material).scale = {mirrored, 1, 1};
        const PackedScene packed = scene.pack();
        const std::vector<QueryRay> rays{
            {{0, 0, 0.1f}, 0, glm::normalize(glm::vec3(1, 0.2f, 0.3f))},
            {{0.1f, 0.2f, 4}, 0, {0, 0, -1}}};
        for (const Backend backend : test::kBackends) {
            RayQuery query(context(), packed, backend);
            const auto closest = query.closest(rays), any = query.any(rays);
            EXPECT_FALSE(record::isSurface(closest[0]));
            EXPECT_TRUE(record::isSurface(any[0]));
            ASSERT_TRUE(record::isSurface(closest[1]));
            EXPECT_NEAR(record::recordDistance(closest[1]), 3.03, 0.03);
        }
    }
}

TEST_F(AlphaTest, BacksLookTheSameToBothFinders) {
    for (const float mirrored : {1.0f, -1.0f}) {
        test::TestScene scene;
        Material single;
        single.doubleSided = false;
        const int ball = scene.addMesh(makeSphere(1, 32)), material = scene.addMaterial(single);
        scene.add(ball, material).scale = {mirrored, 1, 1};
        // An eye inside of one ball, looking at another.
        Node& other = scene.add(ball, material);
        other.at = {0.4f, 0.3f, -2};
        other.scale = {0.5f, -0.7f, 0.4f};
        scene.addSun({-0.3f, -1, -0.5f}, 3);
        scene.setEnvironment(0.2f);
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0, 0, 0.5f};
        camera.target = {0.2f, 0.2f, -2};
        camera.fov = 70;
        const LoadedScene loaded = scene.load();
        expectFindersAgree(loaded);
        scene.scene.materials[0].doubleSided = true;
        const ImageRgba8 closed =
            test::drawPicture(scene.load(), Backend::kAuto, request(Primary::kRaster));
        const ImageRgba8 open =
            test::drawPicture(loaded, Backend::kAuto, request(Primary::kRaster));
        EXPECT_GT(compareImages(closed, open).fractionOver, 0.2);
    }
}

}  // namespace
}  // namespace vitrine
