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

/// Rays straight down on the middles of the texels of a picture that a plane of half size 1 shows.
std::vector<QueryRay> raysOnTexels() {
    std::vector<QueryRay> rays;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            rays.push_back({{-0.875f + 0.25f * static_cast<float>(x), 1,
                             -0.875f + 0.25f * static_cast<float>(y)},
                            0,
                            {0, -1, 0}});
    return rays;
}

/// The second coordinates are what the first would be, and the first are nonsense.
Mesh planeOnSecondUvs() {
    Mesh plane = makePlane(1, 1);
    plane.uvs2 = plane.uvs;
    for (glm::vec2& uv : plane.uvs) uv = {0.3f * uv.y, 0.2f};
    return plane;
}

/// Its opacity grows from 0 at x = -1 to 1 at x = 1.
Mesh planeThatFades() {
    Mesh plane = makePlane(1, 1);
    for (const glm::vec2& uv : plane.uvs) plane.colors.emplace_back(1, 1, 1, uv.x);
    return plane;
}

void expectStopped(const Context& context, const test::TestScene& scene,
                   const std::vector<bool>& stopped) {
    const PackedScene packed = scene.pack();
    const std::vector<QueryRay> rays = raysOnTexels();
    for (const Backend backend : test::kBackends) {
        RayQuery query(context, packed, backend);
        const auto closest = query.closest(rays), any = query.any(rays);
        for (size_t i = 0; i < rays.size(); ++i) {
            EXPECT_EQ(record::isSurface(closest[i]), stopped[i]) << i;
            EXPECT_EQ(record::isSurface(any[i]), stopped[i]) << i;
        }
    }
}

TEST_F(AlphaTest, RaysPassHolesAndNothingElse) {
    const auto image = leaf();
    std::vector<bool> solid;
    for (size_t i = 0; i < 64; ++i) solid.push_back(image->pixels[4 * i + 3] > 127);
    for (const int uvSet : {0, 1}) {
        SCOPED_TRACE(uvSet);
        test::TestScene scene;
        Material m = masked(image);
        m.baseColorTexture.uvSet = uvSet;
        scene.add(scene.addMesh(uvSet == 0 ? makePlane(1, 1) : planeOnSecondUvs()),
                  scene.addMaterial(m));
        expectStopped(context(), scene, solid);
    }
}

TEST_F(AlphaTest, ColoursOfVerticesCutHoles) {
    std::vector<bool> solid;
    for (int i = 0; i < 64; ++i) solid.push_back(i % 8 >= 5);  // opacity (i % 8 + 0.5) / 8
    test::TestScene scene;
    Material m;
    m.alphaMode = AlphaMode::kMask;
    m.alphaCutoff = 0.6f;
    scene.add(scene.addMesh(planeThatFades()), scene.addMaterial(m));
    expectStopped(context(), scene, solid);
}

TEST_F(AlphaTest, ColoursOfVerticesMakeVeils) {
    test::TestScene scene;
    Material m;
    m.baseColor.rgb = glm::vec3(0);
    m.specular = 0;
    m.opacity = 0.5f;
    m.alphaMode = AlphaMode::kBlend;
    scene.add(scene.addMesh(planeThatFades()), scene.addMaterial(m));
    scene.setEnvironment(0.8f);
    Camera& camera = scene.scene.cameras[0];
    camera.eye = {0, 1.5f, 0};
    camera.target = {0, 0, 0};
    camera.up = {0, 0, -1};
    camera.fov = 40;  // the plane fills the picture
    for (const Primary primary : {Primary::kRaster, Primary::kTrace}) {
        PictureRequest r = request(primary, 64);
        r.width = r.height = 64;
        const ImageRgba8 image = test::drawPicture(scene.load(), Backend::kAuto, r);
        for (const int x : {4, 20, 36, 52}) {
            double mean = 0;
            for (int i = 0; i < 8 * 64; ++i)
                mean += test::linearFromSrgb(image.at(x + i % 8, i / 8)[0]) / (8 * 64);
            const double place = 1.5 * std::tan(20 * kPi / 180) * ((x + 4) / 32.0 - 1);
            EXPECT_NEAR(mean, 0.8 * (1 - 0.5 * (place + 1) / 2), 0.012) << x;
        }
    }
}

TEST_F(AlphaTest, LeavesLookTheSameToBothFinders) {
    test::TestScene scene;
    const int plane = scene.addMesh(makePlane(1, 1)), other = scene.addMesh(planeOnSecondUvs());
    Material onSecond = masked(leaf());
    onSecond.baseColorTexture.uvSet = 1;
    const int leaves = scene.addMaterial(masked(leaf())), others = scene.addMaterial(onSecond);
    Material mirror;
    mirror.baseColor.rgb = glm::vec3(0.9f);
    mirror.metallic = 1;
    mirror.roughness = 0;
    scene.add(scene.addMesh(makePlane(5, 5)), scene.addMaterial(mirror));
    for (int i = 0; i < 5; ++i) {
        Node& node = i < 3 ? scene.add(plane, leaves) : scene.add(other, others);
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
