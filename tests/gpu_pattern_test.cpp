// SPDX-License-Identifier: MIT
// What material snippets see of a surface, on the GPU: patterns against the same text in double
// precision, and curvature against that of shapes whose curvature is known.
#include <set>

#include "gpu_support.hpp"
#include "mesh/primitives.hpp"
#include "pattern_pages.hpp"
#include "sdf/library_in_cpp.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 96, kHeight = 64;

/// Shows a value from -1 to 1 of whatever surface, as light of its own.
std::string showing(const std::string& value) {
    return "void material(inout Surface s) { s.baseColor = vec3(0.0); s.specular = 0.0;\n"
           "s.emission = vec3(0.5 + 0.5 * (" +
           value + ")); }";
}

class PatternTest : public test::GpuTest {
  protected:
    static ImageRgba8 draw(const test::TestScene& scene, Backend backend = Backend::kAuto,
                           View view = View::kColor) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = 1;
        request.view = view;
        return test::drawPicture(scene.load(), backend, request);
    }
    /// The value that showing() showed in the middle of the picture; its mean over some pixels.
    static double shown(const test::TestScene& scene, Backend backend = Backend::kAuto) {
        const ImageRgba8 image = draw(scene, backend);
        double sum = 0;
        for (int y = -2; y < 2; ++y)
            for (int x = -2; x < 2; ++x)
                sum += test::linearFromSrgb(image.at(kWidth / 2 + x, kHeight / 2 + y)[0]);
        return 2 * sum / 16 - 1;
    }
    static Camera towards(const glm::vec3& target, const glm::vec3& eye) {
        Camera camera;
        camera.eye = eye;
        camera.target = target;
        camera.fov = 1;
        return camera;
    }
};

/// Where a ray meets the box of half size 0.8, and everything that a snippet is told there.
std::optional<PatternPlace> onTheBox(const Ray& ray, double pixelRadius) {
    const glm::dvec3 o(ray.origin), d(ray.direction);
    double enter = 0, leave = 1e9;
    int axis = 0;
    for (int i = 0; i < 3; ++i) {
        const double a = (-0.8 - o[i]) / d[i], b = (0.8 - o[i]) / d[i];
        if (std::min(a, b) > enter) {
            enter = std::min(a, b);
            axis = i;
        }
        leave = std::min(leave, std::max(a, b));
    }
    if (enter >= leave) return {};
    PatternPlace place;
    place.p = o + enter * d;
    place.n = glm::dvec3(0);
    place.n[axis] = d[axis] < 0 ? 1 : -1;
    place.r = 0.02;
    // The corners of a square across the ray, thrown along the ray onto the plane of the side; its
    // inscribed circle becomes an ellipse, whose extents are the roots of sums of squares.
    const auto frame = test::frameOf(ray.direction);
    glm::dvec3 squares(0);
    for (const glm::vec3& side : frame) {
        const glm::dvec3 across = pixelRadius * enter * glm::dvec3(side);
        const glm::dvec3 thrown = across - across[axis] / d[axis] * d;
        squares += thrown * thrown;
    }
    place.w = 2.0 * glm::sqrt(squares);
    return place;
}

/// Within rounding and dither.
template <class Pixel>
bool isColor(const Pixel& pixel, const glm::dvec3& color) {
    for (int k = 0; k < 3; ++k) {
        const double c = std::clamp(color[k], 0.0, 1.0);
        const double v = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
        if (std::abs(pixel[k] - 255 * v) > 3.5) return false;
    }
    return true;
}

/// One snippet that shows any of the patterns, so that there is one program to compile.
std::string allPatterns() {
    std::string text =
        "uniform int which;  // slider[0, 0, 1000]\n"
        "void material(inout Surface s) {\n"
        "    vec3 p = s.localPosition, n = s.localNormal, w = s.localFootprint;\n"
        "    float k = s.curvature, r = s.curvatureRadius;\n"
        "    s.baseColor = vec3(0.0);\n    s.specular = 0.0;\n";
    for (size_t i = 0; i < library::kPatterns.size(); ++i)
        text += fmt::format("    if (which == {}) s.emission = vec3({});\n", i,
                            library::kPatterns[i].text);
    return text + "}\n";
}

TEST_F(PatternTest, LookAsTheyDoInDoublePrecision) {
    test::TestScene scene;
    Camera& camera = scene.scene.cameras[0];
    camera.eye = {2.4f, 1.9f, 3.1f};
    camera.target = {0, 0, 0};
    camera.fov = 30;
    const double pixelRadius = std::tan(glm::radians(30.0) / 2) / kHeight;
    scene.add(scene.addMesh(makeBox(glm::vec3(0.8f))), scene.addMaterial({}, allPatterns()));
    PictureRequest request;
    request.width = kWidth;
    request.height = kHeight;
    request.samples = 1;
    const LoadedScene loaded = scene.load();
    for (const Backend backend : test::kBackends) {
        Renderer renderer(loaded, backend, false);
        for (size_t i = 0; i < library::kPatterns.size(); ++i) {
            const Pattern& pattern = library::kPatterns[i];
            SCOPED_TRACE(pattern.text + ", " + test::nameOf(backend));
            Scene changed = scene.scene;
            changed.materials[0].set = {{"which", glm::vec4(static_cast<float>(i)), 1, {}}};
            renderer.change(changed);
            const ImageRgba8 image = renderer.draw(request, nullptr);
            int seen = 0, different = 0;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    const Ray ray = test::pixelRay(camera, kWidth, kHeight, x, y);
                    const auto place = onTheBox(ray, pixelRadius);
                    if (!place) continue;
                    ++seen;
                    different += isColor(image.at(x, y), pattern.color(*place)) ? 0 : 1;
                }
            EXPECT_GT(seen, 1200);
            // Edges of the box, and cells whose number is decided by the last bit.
            EXPECT_LE(different, seen / 60);
        }
    }
    std::set<std::string> functions;
    for (const Pattern& pattern : library::kPatterns) functions.insert(pattern.function);
    for (const LibraryFunction& f : sdfLibrary().functions()) {
        if (isPattern(f)) {
            EXPECT_EQ(functions.count(f.name), 1u) << f.name;
        }
    }
}

TEST_F(PatternTest, AFieldsBallHasTheCurvatureOfItsRadius) {
    struct Case {
        double radius;
        float scale;
        const char* field;
        double expected;  // times the radius in the world
    };
    const Case cases[] = {
        {0.25, 1, "length(p) - 0.25", 1},
        {1, 1, "length(p) - 1.0", 1},
        {1, 3, "length(p) - 1.0", 1},
        {0.5, 0.2f, "length(p) - 0.5", 1},
        {1, 1, "0.3 * (length(p) - 1.0)", 1},                                 // not steep enough
        {1, 1, "0.5 * (dot(p, p) - 1.0)", 1},                                 // not a distance
        {1, 1, "length(p.yz) - 1.0", 0.5},                                    // a cylinder
        {1, 1, "max(p.z - 1.0, -1.0)", 0},                                    // a plane
        {1, 1, "max(1.0 - length(p - vec3(0.0, 0.0, 2.0)), p.z - 1.5)", -1},  // a hollow
    };
    int number = 0;
    for (const Case& c : cases)
        for (const bool aside : {false, true}) {
            if (aside && c.expected != 1) continue;
            const Backend backend = test::kBackends[number++ % 2];
            SCOPED_TRACE(std::string(c.field) + ", scale " + std::to_string(c.scale));
            test::TestScene scene;
            const double radius = c.radius * c.scale;
            Material material;
            material.curvatureRadius = static_cast<float>(0.05 * radius);
            Node& node = scene.add(
                scene.addField("// bounds[-2, -2, -2, 2, 2, 2]\n// lipschitz[2]\n"
                               "float sdf(vec3 p) { return " +
                               std::string(c.field) + "; }"),
                scene.addMaterial(material,
                                  showing("0.8 * s.curvature * " + fmt::format("{:.6f}", radius))));
            node.scale = glm::vec3(c.scale);
            const auto r = static_cast<float>(radius);
            scene.scene.cameras[0] = towards({aside ? 0.3f * r : 0, 0, 0.9f * r}, {0, 0, 6.5f * r});
            EXPECT_NEAR(shown(scene, backend) / 0.8, c.expected, 0.012);
        }
}

TEST_F(PatternTest, AMeshsBallHasTheCurvatureOfItsRadiusAndABoxNone) {
    for (const float scale : {1.0f, 2.5f}) {
        test::TestScene scene;
        const auto snippet = showing(fmt::format("0.8 * s.curvature * {:.4f}", scale));
        scene.add(scene.addMesh(makeSphere(1, 64)), scene.addMaterial({}, snippet)).scale =
            glm::vec3(scale);
        scene.scene.cameras[0] = towards({0, 0.1f, 0}, {0.3f, 0.2f, 9});
        EXPECT_NEAR(shown(scene) / 0.8, 1, 0.01);
    }
    test::TestScene cylinder;
    cylinder.add(cylinder.addMesh(makeCylinder(1, 1, 128)),
                 cylinder.addMaterial({}, showing("s.curvature")));
    cylinder.scene.cameras[0] = towards({0, 0, 0}, {0.3f, 0.2f, 9});
    EXPECT_NEAR(shown(cylinder), 0.5, 0.01);
    test::TestScene box;
    box.add(box.addMesh(makeBox(glm::vec3(1))), box.addMaterial({}, showing("s.curvature")));
    box.scene.cameras[0] = towards({0.99f, 0, 1}, {0.3f, 0.2f, 9});
    EXPECT_NEAR(shown(box), 0, 0.01);
}

TEST_F(PatternTest, AnEdgeIsAsWideAsItsRadius) {
    // Twice curvature times radius is 1 on the edge and falls to 0 at the radius.
    test::TestScene scene;
    Material material;
    material.curvatureRadius = 0.2f;
    scene.add(scene.addField("// bounds[-1.1, -1.1, -1.1, 1.1, 1.1, 1.1]\n"
                             "float sdf(vec3 p) { return sdBox(p, vec3(1.0)); }"),
              scene.addMaterial(material, showing("2.0 * s.curvature * s.curvatureRadius")));
    for (const float way : {0.02f, 0.1f, 0.15f, 0.25f, 0.6f}) {
        scene.scene.cameras[0] = towards({1 - way, 0, 1}, {1 - way, 0, 9});
        EXPECT_NEAR(shown(scene), std::max(0.0, 1 - way / 0.2), 0.03) << way;
    }
}

TEST_F(PatternTest, CurvatureIsSeenInMirrorsAndLeavesPartsAlone) {
    // A ball with two parts, seen by a mirror; its right half shows curvature.
    const char* field =
        "// bounds[-1.1, -1.1, -1.1, 1.1, 1.1, 1.1]\n// parts[left, right]\n"
        "vec2 sdf(vec3 p) { return vec2(length(p) - 1.0, p.x < 0.0 ? 0.0 : 1.0); }";
    Material shows, plain, mirror;
    plain.baseColor.rgb = glm::vec3(0);
    plain.specular = 0;
    plain.emission.rgb = glm::vec3(0.25f);
    mirror.metallic = 1;
    mirror.roughness = 0;
    mirror.baseColor.rgb = glm::vec3(1);
    for (const Backend backend : test::kBackends) {
        test::TestScene scene;
        const int show = scene.addMaterial(shows, showing("0.6 * s.curvature"));
        const int flat = scene.addMaterial(plain);
        Node& ball = scene.add(scene.addField(field));
        ball.parts = {{"left", {scene.scene.materials[static_cast<size_t>(flat)].name, {}}},
                      {"right", {scene.scene.materials[static_cast<size_t>(show)].name, {}}}};
        ball.partPlaces.resize(2);
        scene.add(scene.addMesh(makePlane(9, 9)), scene.addMaterial(mirror)).at = {0, -3, 0};
        scene.scene.render.bounces = 1;
        for (const float side : {-0.5f, 0.5f}) {
            scene.scene.cameras[0] = towards({side, -3, 0}, {side, 0, 12});
            // The mirror image of the eye sees the ball: aim for the ball's image at y = -6.
            scene.scene.cameras[0].target = {side, -6, 0};
            const double expected = side < 0 ? 2 * 0.25 - 1 : 0.6;
            EXPECT_NEAR(shown(scene, backend), expected, 0.02) << side;
        }
        // The numbers of its parts are what they are without.
        scene.scene.cameras[0].eye = {0, 0, 12};
        scene.scene.cameras[0].target = {0, 0, 0};
        scene.scene.cameras[0].fov = 14;
        const ImageRgba8 with = draw(scene, backend, View::kPrimitive);
        test::TestScene without;
        without.add(without.addField(field));
        without.scene.cameras[0] = scene.scene.cameras[0];
        const ImageRgba8 plainView = draw(without, backend, View::kPrimitive);
        for (const int x : {kWidth / 2 - 10, kWidth / 2 + 10})
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(with.at(x, kHeight / 2)[k], plainView.at(x, kHeight / 2)[k]);
    }
}

TEST_F(PatternTest, TheFloorIsGreyAtTheHorizon) {
    // Rows of the picture towards the horizon: no moire, one sample a pixel.
    test::TestScene scene;
    scene.add(scene.addMesh(makePlane(2000, 2000)),
              scene.addMaterial({},
                                "void material(inout Surface s) { s.baseColor = vec3(0.0); "
                                "s.specular = 0.0; s.emission = vec3(patChecker("
                                "2.0 * s.localPosition.xz, 2.0 * s.localFootprint.xz)); }"));
    Camera& camera = scene.scene.cameras[0];
    camera.eye = {0.3f, 1, 0};
    camera.target = {0.9f, 1, -10};
    camera.fov = 40;
    const ImageRgba8 image = draw(scene);
    for (int y = 0; y < kHeight; ++y) {
        const Ray ray = test::pixelRay(camera, kWidth, kHeight, kWidth / 2, y);
        if (ray.direction.y > -0.005) continue;
        const double away = 1 / -ray.direction.y;
        const double width = 2 * away * std::tan(glm::radians(20.0)) / kHeight * 2;
        for (int x = 0; x < kWidth; ++x) {
            const double seen = test::linearFromSrgb(image.at(x, y)[0]);
            // Lengthwise the pixel is `away` times as wide as high.
            if (width * away > 12) {
                EXPECT_NEAR(seen, 0.5, 0.05) << x << ", " << y;
            }
        }
    }
    // And near the eye it is black and white.
    int black = 0, white = 0;
    for (int x = 0; x < kWidth; ++x) {
        black += image.at(x, kHeight - 1)[0] < 10 ? 1 : 0;
        white += image.at(x, kHeight - 1)[0] > 245 ? 1 : 0;
    }
    EXPECT_GT(black, 20);
    EXPECT_GT(white, 20);
}

TEST_F(PatternTest, OnlyWhoAsksForCurvaturePays) {
    test::TestScene scene;
    const int ball = scene.addField(
        "// bounds[-1, -1, -1, 1, 1, 1]\n"
        "float sdf(vec3 p) { return length(p) - 0.9; }");
    scene.add(ball, scene.addMaterial({}, showing("s.roughness")));
    EXPECT_FALSE(scene.pack().hasCurvature);
    EXPECT_FALSE(scene.pack().hasClassic);
    scene.add(ball, scene.addMaterial({}, showing("s.curvature")));
    EXPECT_TRUE(scene.pack().hasCurvature);
}

}  // namespace
}  // namespace vitrine
