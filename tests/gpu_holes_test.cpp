// SPDX-License-Identifier: MIT
// Pictures of fields that are no distances. Rods of which the true outline is known on paper: a
// pixel whose ray passes the middle line of a rod by less than its radius, less a pixel, has to
// show it. And fields that are worse than wrong are drawn, or not, as docs/fields.md says.
#include <chrono>

#include "gpu_support.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 320, kHeight = 200;
constexpr double kRadius = 0.08, kHalfHeight = 0.6;
constexpr glm::dvec2 kRods[] = {
    {-0.7, 0.1}, {-0.31, -0.2}, {0.02, 0.25}, {0.36, -0.05}, {0.71, 0.2}};

/// `body` makes what sdf() returns of `d`, the exact distance to the rods.
std::string rods(const std::string& body, const std::string& annotation = "") {
    std::string text = "// bounds[-1, -0.8, -0.4,  1, 0.8, 0.4]\n" + annotation +
                       "float sdf(vec3 p) {\n    float d = 1.0e9;\n";
    for (const glm::dvec2& rod : kRods)
        text += fmt::format(
            "    d = min(d, sdCapsule(p, vec3({0}, -{2}, {1}), vec3({0}, {2}, {1}), {3}));\n",
            rod.x, rod.y, kHalfHeight, kRadius);
    return text + "    return " + body + ";\n}\n";
}

/// The least distance of a ray from the line between a and b.
double distanceBetween(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 o(ray.origin), d(ray.direction), e = b - a, w = o - a;
    const double de = glm::dot(d, e), ee = glm::dot(e, e);
    const double denominator = ee - de * de;  // d has length 1
    double s = std::clamp((glm::dot(w, e) - glm::dot(w, d) * de) / denominator, 0.0, 1.0);
    const double t = glm::dot(a + s * e - o, d);
    s = std::clamp(glm::dot(o + t * d - a, e) / ee, 0.0, 1.0);
    return glm::length(a + s * e - o - glm::dot(a + s * e - o, d) * d);
}

/// Of a picture: pixels that must show a rod, those of them that do not, and pixels that show one
/// where none is.
struct Seen {
    int rods = 0, holes = 0, ghosts = 0;
    double seconds = 0;
};

class HolesTest : public test::GpuTest {
  protected:
    /// Measured as every scene's fields are.
    std::shared_ptr<const Snippet> measured(const std::string& text) {
        Diagnostics diagnostics;
        auto field = parseSnippet(text, "test.sdf.glsl", SnippetKind::kField, diagnostics);
        diagnostics.throwIfErrors();
        FieldProber prober(FieldProber::Thoroughness::kNeeded, &context());
        auto result =
            prober.measure(std::make_shared<const Snippet>(std::move(*field)), {}, diagnostics);
        diagnostics.throwIfErrors();
        return result;
    }

    static Seen look(std::shared_ptr<const Snippet> field, Backend backend) {
        test::TestScene scene;
        scene.add(scene.addField(std::move(field)));
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0.4f, 0.5f, 3};
        camera.target = {0, 0, 0};
        const double pixel = 2 * std::tan(glm::radians(20.0)) * 3.4 / kHeight;
        const LoadedScene loaded = scene.load();
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = 1;
        const auto start = std::chrono::steady_clock::now();
        Renderer renderer(loaded, backend, false);
        const LayerImages layers = renderer.drawLayers(request, nullptr);
        Seen seen;
        seen.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const Ray ray = test::pixelRay(camera, kWidth, kHeight, x, y);
                double away = 1e9;
                for (const glm::dvec2& rod : kRods)
                    away = std::min(away, distanceBetween(ray, {rod.x, -kHalfHeight, rod.y},
                                                          {rod.x, kHalfHeight, rod.y}));
                const bool shown = layers.ids.at(x, y)[0] != kNoId;
                if (away < kRadius - pixel) {
                    ++seen.rods;
                    seen.holes += shown ? 0 : 1;
                }
                seen.ghosts += shown && away > kRadius + pixel ? 1 : 0;
            }
        return seen;
    }
};

TEST_F(HolesTest, AWrongFieldHasNoneUnlessItsAuthorInsists) {
    const std::string three = "3.0 * d", insists = "// lipschitz[1]\n";
    for (const Backend backend : test::kBackends) {
        SCOPED_TRACE(test::nameOf(backend));
        const Seen exact = look(measured(rods("d")), backend);
        const Seen derived = look(measured(rods(three)), backend);
        const Seen insisted = look(measured(rods(three, insists)), backend);
        fmt::print(
            "{} pixels of rods; holes: {} in the exact field, {} with the derived step, {} "
            "with lipschitz[1]\n",
            exact.rods, exact.holes, derived.holes, insisted.holes);
        EXPECT_GT(exact.rods, 5000);
        EXPECT_EQ(exact.holes, 0);
        EXPECT_EQ(derived.holes, 0);
        EXPECT_EQ(exact.ghosts + derived.ghosts, 0);
        EXPECT_GT(insisted.holes, insisted.rods / 10);
    }
}

TEST_F(HolesTest, SteepOnlyAtTheSurface) {
    // The square root rises without limit where it starts, so no step is safe there. What is found
    // is the slope at the smallest scale, and a step that is too long there still ends inside.
    for (const char* body : {"d < 0.0 ? d : sqrt(d)", "d < 0.0 ? -sqrt(-d) : sqrt(d)"}) {
        const Seen seen = look(measured(rods(body)), Backend::kFragment);
        EXPECT_EQ(seen.holes, 0) << body;
        EXPECT_EQ(seen.ghosts, 0) << body;
    }
}

TEST_F(HolesTest, FieldsThatSayNothingAreDrawnAndDoNotHang) {
    struct Case {
        const char* body;
        bool shown;
    };
    for (const Case& c :
         {Case{"sqrt(-1.0 - d * d)", false}, Case{"-1.0", true}, Case{"0.0", true},
          Case{"1.0", false}, Case{"1.0 / max(d - 100.0, 0.0)", false}, Case{"1.0e-9", true}}) {
        SCOPED_TRACE(c.body);
        const Seen seen = look(measured(rods(c.body)), Backend::kFragment);
        // A solid fills its bounds, and the rods stand in them; what is empty shows nothing.
        EXPECT_EQ(seen.holes, c.shown ? 0 : seen.rods);
        if (c.shown)
            EXPECT_GT(seen.ghosts, kWidth * kHeight / 4);
        else
            EXPECT_EQ(seen.ghosts, 0);
        EXPECT_LT(seen.seconds, 60) << "a tenth of a second on a machine with nothing else to do";
    }
}

}  // namespace
}  // namespace vitrine
