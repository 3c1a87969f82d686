// SPDX-License-Identifier: MIT
// Materials as in textbooks, against the textbooks: Lambert's cosine, and Blinn's highlight with
// its peak, its shape and its energy.
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 96, kHeight = 64;
constexpr double kExactPi = glm::pi<double>();
constexpr const char* kBallField =
    "// bounds[-1.05, -1.05, -1.05, 1.05, 1.05, 1.05]\n"
    "float sdf(vec3 p) { return length(p) - 1.0; }";

/// Blinn's highlight times the cosine, for a unit share of light.
double blinnPhong(double shininess, const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l) {
    const double scale = (shininess + 2) * (shininess + 4) /
                         (8 * kExactPi * (shininess + std::pow(2.0, -shininess / 2)));
    const double nl = std::max(glm::dot(n, l), 0.0);
    return scale * std::pow(std::max(glm::dot(n, glm::normalize(v + l)), 0.0), shininess) * nl;
}

/// What a unit share sends back of light from the direction (sine, 0, cosine), in all.
double highlightAlbedo(double shininess, double cosine) {
    const glm::dvec3 n(0, 0, 1), v(std::sqrt(1 - cosine * cosine), 0, cosine);
    constexpr int kPolar = 800, kAround = 800;
    double sum = 0;
    for (int i = 0; i < kPolar; ++i)
        for (int j = 0; j < kAround; ++j) {
            const double polar = kExactPi / 2 * (i + 0.5) / kPolar,
                         around = kExactPi * (j + 0.5) / kAround;
            const glm::dvec3 l(std::sin(polar) * std::cos(around),
                               std::sin(polar) * std::sin(around), std::cos(polar));
            sum += blinnPhong(shininess, n, v, l) * std::sin(polar);
        }
    return sum * kExactPi / 2 / kPolar * kExactPi / kAround * 2;
}

Material classic(SurfaceModel model, float base) {
    Material m;
    m.model = model;
    m.baseColor.rgb = glm::vec3(base);
    // What textbooks do not know must not matter.
    m.metallic = 0.7f;
    m.roughness = 0.1f;
    m.clearcoat = 1;
    m.transmission = 0.5f;
    m.sheenColor.rgb = glm::vec3(0.5f);
    m.subsurface = 0.5f;
    return m;
}

class ClassicTest : public test::GpuTest {
  protected:
    static test::TestScene ballUnderASun(const Material& material, bool field, const glm::vec3& sun,
                                         float irradiance) {
        test::TestScene scene;
        scene.add(field ? scene.addField(kBallField) : scene.addMesh(makeSphere(1, 256)),
                  scene.addMaterial(material));
        scene.addSun(sun, irradiance);
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0, 0, 5};
        camera.target = {0, 0, 0};
        camera.fov = 26;
        return scene;
    }
    static ImageRgba8 draw(const test::TestScene& scene, Backend backend,
                           RenderMode mode = RenderMode::kHybrid, int samples = 1) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = samples;
        request.mode = mode;
        return test::drawPicture(scene.load(), backend, request);
    }
    /// Compares a ball with a formula of (normal, to the viewer), wherever the sun is not edge on:
    /// within rounding and dither, in steps of 8 bits. Rays meet fields up to a fifth of a pixel in
    /// front, which on a small picture tilts normals by half a degree, and more at the rim.
    template <class Formula>
    static void expectBall(const test::TestScene& scene, const ImageRgba8& image,
                           const glm::dvec3& toSun, bool field, const Formula& formula) {
        const double tolerance = field ? 4 : 2.6, rim = field ? 0.5 : 0.05;
        const Camera& camera = scene.scene.cameras[0];
        int count = 0;
        double worst = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const Ray ray = test::pixelRay(camera, kWidth, kHeight, x, y);
                const glm::dvec3 o(ray.origin), d(ray.direction);
                const double od = glm::dot(o, d), root = od * od - glm::dot(o, o) + 1;
                if (root < rim) continue;
                const glm::dvec3 n = o + (-od - std::sqrt(root)) * d;
                if (std::abs(glm::dot(n, toSun)) < (field ? 0.15 : 0.05)) continue;
                const double expected = glm::dot(n, toSun) > 0 ? formula(n, -d) : 0;
                const double code =
                    255 * (expected > 0 ? 1.055 * std::pow(expected, 1 / 2.4) - 0.055 : 0);
                worst = std::max(worst, std::abs(image.at(x, y)[0] - code));
                ++count;
            }
        EXPECT_LT(worst, tolerance);
        EXPECT_GT(count, 500);
    }
};

TEST_F(ClassicTest, ALambertBallHasTheRadianceOnPaper) {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.5f, -0.6f, -0.7f));
    const glm::dvec3 toSun = -glm::dvec3(sun);
    constexpr float kIrradiance = 3.5f, kAlbedo = 0.75f;
    for (const Backend backend : test::kBackends)
        for (const bool field : {false, true})
            for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference}) {
                SCOPED_TRACE(test::nameOf(backend) + (field ? ", field" : ", mesh"));
                const auto scene = ballUnderASun(classic(SurfaceModel::kLambert, kAlbedo), field,
                                                 sun, kIrradiance);
                EXPECT_TRUE(scene.pack().hasClassic);
                EXPECT_FALSE(scene.pack().hasTransmission);
                EXPECT_FALSE(scene.pack().hasSubsurface);
                expectBall(scene, draw(scene, backend, mode), toSun, field,
                           [&](const glm::dvec3& n, const glm::dvec3&) {
                               return double{kAlbedo} / kExactPi * kIrradiance * glm::dot(n, toSun);
                           });
            }
}

/// Whatever else it has, an unlit ball shows its colour on all sides.
TEST_F(ClassicTest, AnUnlitBallIsItsColor) {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.5f, -0.6f, 0.7f));
    constexpr float kColor = 0.4f;
    const double code = 255 * (1.055 * std::pow(kColor, 1 / 2.4) - 0.055);
    Material material = classic(SurfaceModel::kPbr, kColor);
    material.transmission = 0;
    material.unlit = true;
    for (const bool field : {false, true}) {
        SCOPED_TRACE(field ? "field" : "mesh");
        const auto scene = ballUnderASun(material, field, sun, 3.5f);
        const ImageRgba8 image = draw(scene, Backend::kFragment);
        const Camera& camera = scene.scene.cameras[0];
        int count = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const Ray ray = test::pixelRay(camera, kWidth, kHeight, x, y);
                const glm::vec3 nearest =
                    ray.origin - glm::dot(ray.origin, ray.direction) * ray.direction;
                if (glm::length(nearest) > 0.95f) continue;
                EXPECT_NEAR(image.at(x, y)[0], code, 1.6);  // rounding and dither
                ++count;
            }
        EXPECT_GT(count, 500);
    }
}

TEST_F(ClassicTest, BlinnsHighlightHasItsShapeAndItsPeak) {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.3f, -0.4f, -0.85f));
    const glm::dvec3 toSun = -glm::dvec3(sun);
    for (const Backend backend : test::kBackends)
        for (const bool field : {false, true})
            for (const double shininess : {4.0, 25.0}) {
                SCOPED_TRACE(test::nameOf(backend) + (field ? ", field" : ", mesh"));
                Material material = classic(SurfaceModel::kBlinnPhong, 0.5f);
                material.highlightColor.rgb = glm::vec3(0.3f);
                material.shininess = static_cast<float>(shininess);
                constexpr double kIrradiance = 1.0;
                const auto scene = ballUnderASun(material, field, sun, kIrradiance);
                const auto formula = [&](const glm::dvec3& n, const glm::dvec3& v) {
                    return kIrradiance * (0.7 * 0.5 / kExactPi * glm::dot(n, toSun) +
                                          0.3 * blinnPhong(shininess, n, v, toSun));
                };
                expectBall(scene, draw(scene, backend), toSun, field, formula);
            }
}

TEST_F(ClassicTest, ThePeakIsTheNormalisation) {
    // A floor that mirrors the sun into the eye: the half vector is the normal.
    for (const double shininess : {1.0, 10.0, 100.0}) {
        const double peak = (shininess + 8) / (8 * kExactPi);  // Real-Time Rendering, third edition
        const float ks = static_cast<float>(std::min(0.6 / (peak * std::cos(0.5)), 0.9));
        Material material = classic(SurfaceModel::kBlinnPhong, 0);
        material.highlightColor.rgb = glm::vec3(ks);
        material.shininess = static_cast<float>(shininess);
        test::TestScene scene;
        scene.add(scene.addMesh(makePlane(5, 5)), scene.addMaterial(material));
        const auto sine = static_cast<float>(std::sin(0.5)),
                   cosine = static_cast<float>(std::cos(0.5));
        scene.addSun({-sine, -cosine, 0}, 1);
        scene.scene.cameras[0].eye = {-8 * sine, 8 * cosine, 0};
        scene.scene.cameras[0].target = {0, 0, 0};
        scene.scene.cameras[0].fov = 0.5f;
        const ImageRgba8 image = draw(scene, Backend::kAuto);
        const double exact = blinnPhong(shininess, {0, 1, 0}, {0, 1, 0}, {0, 1, 0});
        EXPECT_NEAR(exact / peak, 1, 0.14);
        const double seen = test::linearFromSrgb(image.at(kWidth / 2, kHeight / 2)[0]);
        EXPECT_NEAR(seen, ks * exact * std::cos(0.5), 0.006) << shininess;
    }
}

TEST(ClassicHighlight, SendsBackAllStraightOnAndNoMoreFromTheSide) {
    for (const double shininess : {1.0, 8.0, 60.0}) {
        EXPECT_NEAR(highlightAlbedo(shininess, 0.99999), 1, 0.005) << shininess;
        for (const double cosine : {0.9, 0.7, 0.5, 0.3, 0.1})
            EXPECT_LT(highlightAlbedo(shininess, cosine), 1.005) << shininess << ", " << cosine;
    }
}

TEST_F(ClassicTest, EnergyIsNeitherMadeNorLost) {
    // In surroundings of one brightness: Lambert exactly, Blinn no more than it was given.
    for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference})
        for (const bool shiny : {false, true}) {
            Material material =
                classic(shiny ? SurfaceModel::kBlinnPhong : SurfaceModel::kLambert, 1);
            material.highlightColor.rgb = glm::vec3(0.5f);
            material.shininess = 5;
            test::TestScene scene;
            scene.add(scene.addField(kBallField), scene.addMaterial(material));
            scene.setEnvironment(0.5f);
            scene.scene.render.bounces = 1;
            scene.scene.render.threshold = 0;
            scene.scene.cameras[0].eye = {0, 0, 5};
            scene.scene.cameras[0].target = {0, 0, 0};
            scene.scene.cameras[0].fov = 4;
            const ImageRgba8 image = draw(scene, Backend::kAuto, mode, 12);
            double sum = 0;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) sum += test::linearFromSrgb(image.at(x, y)[0]);
            const double share = sum / (kWidth * kHeight) / 0.5;
            // In hybrid mode what mirrors is lit by lights alone, as the documentation says.
            const double expected = shiny && mode == RenderMode::kHybrid ? 0.5 : 1;
            EXPECT_NEAR(share, expected, 0.015) << shiny;
        }
}

TEST_F(ClassicTest, ASnippetSetsTheHighlight) {
    Material material = classic(SurfaceModel::kBlinnPhong, 0);
    material.highlightColor.rgb = glm::vec3(0);
    const char* snippet =
        "void material(inout Surface s) { s.highlightColor = vec3(0.4); s.shininess = 9.0; }";
    test::TestScene scene;
    scene.add(scene.addMesh(makePlane(5, 5)), scene.addMaterial(material, snippet));
    scene.addSun({0, -1, 0}, 1);
    scene.scene.cameras[0].eye = {0, 6, 0.01f};
    scene.scene.cameras[0].target = {0, 0, 0};
    scene.scene.cameras[0].fov = 1;
    const ImageRgba8 image = draw(scene, Backend::kAuto);
    EXPECT_NEAR(test::linearFromSrgb(image.at(kWidth / 2, kHeight / 2)[0]),
                0.4 * blinnPhong(9, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}), 0.006);
}

}  // namespace
}  // namespace vitrine
