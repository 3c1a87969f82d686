// SPDX-License-Identifier: MIT
// The short cuts that fields allow: a half shadow from one ray, and occlusion from five taps. Both
// against a formula and against what they stand for, the sampled light and the occlusion rays.
#include <cmath>

#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 96, kHeight = 32;

/// A box as a field, exact outside.
std::string boxField(const glm::vec3& low, const glm::vec3& high) {
    const glm::vec3 c = (low + high) / 2.0f, h = (high - low) / 2.0f;
    return fmt::format(
        "// bounds[{}, {}, {}, {}, {}, {}]\n"
        "float sdf(vec3 p) {{\n"
        "    vec3 q = abs(p - vec3({:.5f}, {:.5f}, {:.5f})) - vec3({:.5f}, {:.5f}, {:.5f});\n"
        "    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);\n"
        "}}",
        low.x, low.y, low.z, high.x, high.y, high.z, c.x, c.y, c.z, h.x, h.y, h.z);
}

class ConeTest : public test::GpuTest {
  protected:
    static ImageRgba8 draw(const test::TestScene& scene, int samples = 1, View view = View::kColor,
                           Backend backend = Backend::kAuto,
                           RenderMode mode = RenderMode::kHybrid) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = samples;
        request.view = view;
        request.mode = mode;
        return test::drawPicture(scene.load(), backend, request);
    }
    /// A camera straight above the origin that sees 2 m of the floor from left to right.
    static void lookDown(test::TestScene& scene, float height = 0.9f) {
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0, height, 0.001f};
        camera.target = {0, 0, 0};
        camera.fov = 2 * glm::degrees(std::atan(1.0f / height * kHeight / kWidth));
    }
    static double placeOf(int x) { return 2 * (x + 0.5) / kWidth - 1; }
    /// Mean of a column of pixels.
    static double column(const ImageRgba8& image, int x, bool light) {
        double sum = 0;
        for (int y = 0; y < kHeight; ++y) {
            const double value = image.at(x, y)[0];
            sum += light ? test::linearFromSrgb(value) : value / 255;
        }
        return sum / kHeight;
    }
};

class PenumbraTest : public ConeTest {
  protected:
    static constexpr double kRadius = 8;  // of the sun, degrees
    static test::TestScene floor() {
        test::TestScene scene;
        Material matt;
        matt.baseColor.rgb = glm::vec3(0.8f);
        matt.roughness = 1;
        matt.specular = 0;
        scene.add(scene.addMesh(makePlane(50, 50)), scene.addMaterial(matt));
        lookDown(scene);
        scene.addSun({0, -1, 0}, 3);
        scene.scene.lights[0].radius = kRadius;
        scene.scene.render.bounces = 0;
        return scene;
    }
    /// The share of light by column.
    static std::vector<double> shares(const test::TestScene& scene, ShadowMethod method,
                                      Backend backend = Backend::kAuto) {
        const int samples = method == ShadowMethod::kSampled ? 64 : 1;
        test::TestScene covered = scene, open = floor();
        covered.scene.render.shadows = open.scene.render.shadows = method;
        const ImageRgba8 a = draw(covered, samples, View::kColor, backend);
        const ImageRgba8 b = draw(open, samples, View::kColor, backend);
        std::vector<double> result;
        for (int x = 0; x < kWidth; ++x) result.push_back(column(a, x, true) / column(b, x, true));
        return result;
    }
    /// Where the shares, which fall from left to right, pass a value, in m.
    static double placeWhere(const std::vector<double>& shares, double value) {
        for (int x = 1; x < kWidth; ++x)
            if (shares[x] < value) {
                const double part = (shares[x - 1] - value) / (shares[x - 1] - shares[x]);
                return placeOf(x - 1) + part * (placeOf(1) - placeOf(0));
            }
        return 2;
    }
    static double smooth(double s) {
        s = std::clamp(s, 0.0, 1.0);
        return s * s * (3 - 2 * s);
    }
};

TEST_F(PenumbraTest, OfAnEdgeIsTheOuterHalfOfTheSampledOne) {
    const double slope = std::tan(glm::radians(kRadius));
    for (const Backend backend : test::kBackends)
        for (const float thickness : {0.02f, 0.6f}) {
            SCOPED_TRACE(test::nameOf(backend) + fmt::format(", {} m thick", thickness));
            test::TestScene scene = floor();
            scene.add(scene.addField(boxField({0, 1, -9}, {9, 1 + thickness, 9})));
            const auto one = shares(scene, ShadowMethod::kPenumbra, backend);
            const auto all = shares(scene, ShadowMethod::kSampled, backend);
            // The upper edge is the first that the light's rim meets.
            const double width = slope * (1 + thickness);
            double worst = 0;
            for (int x = 0; x < kWidth; ++x) {
                const double p = placeOf(x);
                worst = std::max(worst, std::abs(one[x] - smooth(-p / width)));
                if (p > 0.02) {
                    EXPECT_LT(one[x], 0.01) << p;
                }
                if (p < -1.25 * width) {
                    EXPECT_GT(one[x], 0.98) << p;
                }
                // What all of the light says is lit or dark is so here.
                if (all[x] < 0.002) {
                    EXPECT_LT(one[x], 0.01) << p;
                }
                if (all[x] > 0.999 && p < -1.25 * width) {
                    EXPECT_GT(one[x], 0.98) << p;
                }
            }
            const double ours = placeWhere(one, 0.02) - placeWhere(one, 0.98);
            const double half = placeWhere(all, 0.5) - placeWhere(all, 0.98);
            fmt::print(
                "{} m thick: from dark to light {:.3f} m, outer half of the sampled {:.3f} "
                "m, off the formula by {:.3f} at most\n",
                thickness, ours, half, worst);
            EXPECT_NEAR(ours / half, 1, 0.2);
            EXPECT_NEAR(placeWhere(one, 0.01), 0, 0.03);
            EXPECT_LT(worst, 0.12);
        }
}

TEST_F(PenumbraTest, OfASphereEndsWhereTheSampledOneDoes) {
    test::TestScene scene = floor();
    scene.add(
        scene.addField("// bounds[-0.3, 0.4, -0.3, 0.3, 1, 0.3]\n"
                       "float sdf(vec3 p) { return length(p - vec3(0, 0.7, 0)) - 0.3; }"));
    lookDown(scene, 0.35f);
    // A strip through its middle.
    scene.scene.cameras[0].fov = 10;
    const auto light = [&](ShadowMethod method, bool covered) {
        test::TestScene copy = covered ? scene : floor();
        copy.scene.cameras = scene.scene.cameras;
        copy.scene.cameras[0].eye = {0.3f, 0.3f, 0.001f};
        copy.scene.cameras[0].target = {0.3f, 0, 0};
        copy.scene.cameras[0].fov = 2 * glm::degrees(std::atan(0.25f / 0.3f * kHeight / kWidth));
        copy.scene.render.shadows = method;
        const ImageRgba8 image = draw(copy, method == ShadowMethod::kSampled ? 128 : 4);
        std::vector<double> row;
        for (int x = 0; x < kWidth; ++x)
            row.push_back((test::linearFromSrgb(image.at(x, kHeight / 2)[0]) +
                           test::linearFromSrgb(image.at(x, kHeight / 2 - 1)[0])) /
                          2);
        return row;
    };
    const auto one = light(ShadowMethod::kPenumbra, true),
               open = light(ShadowMethod::kPenumbra, false);
    const auto all = light(ShadowMethod::kSampled, true),
               openAll = light(ShadowMethod::kSampled, false);
    const double slope = std::tan(glm::radians(kRadius));
    double worst = 0;
    for (int x = 0; x < kWidth; ++x) {
        const double p = 0.3 + 0.25 * placeOf(x);
        const double a = one[x] / open[x], b = all[x] / openAll[x];
        double ratio = 1;
        for (double t = 0.01; t < 2; t += 0.002)
            ratio = std::min(ratio, (std::hypot(p, t - 0.7) - 0.3) / (slope * t));
        worst = std::max(worst, std::abs(a - smooth(ratio)));
        if (b < 0.005) {
            EXPECT_LT(a, 0.01) << p;
        }
        if (p > 0.3 + 1.2 * 0.7 * slope) {
            EXPECT_GT(b, 0.97) << p;
            EXPECT_GT(a, 0.97) << p;
        }
        if (p < 0.29) {
            EXPECT_LT(a, 0.02) << p;
        }
    }
    fmt::print("off the formula by {:.3f} at most\n", worst);
    // Where two of the marching spheres intersect, a round thing is farther than guessed.
    EXPECT_LT(worst, 0.15);
}

TEST_F(PenumbraTest, OfTwoFieldsIsThatOfTheirUnion) {
    test::TestScene two = floor(), united = floor();
    two.add(two.addField(boxField({0.1f, 0.92f, -1}, {0.9f, 1.2f, 1})));
    two.add(two.addField(boxField({-0.8f, 0.92f, -1}, {-0.25f, 1.0f, 1})));
    united.add(
        united.addField("// bounds[-0.8, 0.92, -1, 0.9, 1.2, 1]\n"
                        "float box(vec3 p, vec3 c, vec3 h) {\n"
                        "    vec3 q = abs(p - c) - h;\n"
                        "    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);\n"
                        "}\n"
                        "float sdf(vec3 p) {\n"
                        "    return min(box(p, vec3(0.5, 1.06, 0), vec3(0.4, 0.14, 1)),\n"
                        "               box(p, vec3(-0.525, 0.96, 0), vec3(0.275, 0.04, 1)));\n"
                        "}"));
    const auto a = shares(two, ShadowMethod::kPenumbra);
    const auto b = shares(united, ShadowMethod::kPenumbra);
    for (int x = 0; x < kWidth; ++x) EXPECT_NEAR(a[x], b[x], 0.08) << placeOf(x);
}

TEST_F(PenumbraTest, LeavesMeshesHardAndTheReferenceAlone) {
    test::TestScene scene = floor();
    scene.add(scene.addMesh(makePlane(4, 9))).at = {4, 1, 0};
    const auto mesh = shares(scene, ShadowMethod::kPenumbra);
    int between = 0;
    for (const double share : mesh) between += share > 0.02 && share < 0.98;
    EXPECT_LE(between, 1);
    EXPECT_NEAR(placeWhere(mesh, 0.5), 0, 0.03);

    test::TestScene field = floor();
    field.add(field.addField(boxField({0, 1, -9}, {9, 1.02f, 9})));
    const auto reference = [&] {
        return draw(field, 2, View::kColor, Backend::kAuto, RenderMode::kReference).pixels;
    };
    const auto sampled = reference();
    field.scene.render.shadows = ShadowMethod::kPenumbra;
    EXPECT_EQ(reference(), sampled);
}

class TapsTest : public ConeTest {
  protected:
    static constexpr float kReach = 0.8f;
    static test::TestScene scene(float amount, OcclusionMethod method) {
        test::TestScene made;
        made.setEnvironment(1);
        made.scene.render.ao = amount;
        made.scene.render.aoDistance = kReach;
        made.scene.render.aoMode = method;
        made.scene.render.bounces = 0;
        lookDown(made, 2.0f);
        return made;
    }
    static std::string floorField() { return boxField({-3, -0.5f, -3}, {3, 0, 3}); }
    static std::string wallField() { return boxField({-3, 0, -3}, {0, 1.5f, 3}); }
    static std::vector<double> openness(const test::TestScene& scene, int samples = 1,
                                        Backend backend = Backend::kAuto) {
        const ImageRgba8 image = draw(scene, samples, View::kAo, backend);
        std::vector<double> result;
        for (int x = 0; x < kWidth; ++x) result.push_back(column(image, x, false));
        return result;
    }
    static std::vector<double> crease(float amount, OcclusionMethod method, int samples = 1,
                                      Backend backend = Backend::kAuto) {
        test::TestScene made = scene(amount, method);
        made.add(made.addField(floorField()));
        made.add(made.addField(wallField()));
        return openness(made, samples, backend);
    }
};

TEST_F(TapsTest, APlaneIsOpenHoweverItsFieldIsScaled) {
    const auto expectOpen = [](const std::string& field, const glm::vec3& scale) {
        test::TestScene made = scene(1, OcclusionMethod::kTaps);
        made.add(made.addField(field)).scale = scale;
        for (const double open : openness(made)) EXPECT_NEAR(open, 1, 0.02) << field;
    };
    expectOpen(floorField(), {1, 1, 1});
    expectOpen(floorField(), {2, 0.3f, 2});
    const std::string steep =
        "// bounds[-3, -1, -3, 3, 2, 3]\n// lipschitz[3]\nfloat sdf(vec3 p) {{ return {} * p.y; }}";
    expectOpen(fmt::format(fmt::runtime(steep), "0.4"), {1, 1, 1});
    expectOpen(fmt::format(fmt::runtime(steep), "3.0"), {1, 1, 1});
    // Slanted and squeezed along axes that are not its own.
    expectOpen(
        "// bounds[-3, -4, -3, 3, 4, 3]\n"
        "float sdf(vec3 p) { return 0.7071 * (p.y - p.x); }",
        {1, 0.4f, 1});
}

TEST_F(TapsTest, AWallDarkensAsItDoesWithRays) {
    for (const Backend backend : test::kBackends) {
        SCOPED_TRACE(test::nameOf(backend));
        const auto taps = crease(1, OcclusionMethod::kTaps, 1, backend);
        const auto rays = crease(1, OcclusionMethod::kRays, 16, backend);
        double worst = 0;
        // Beside the wall, whose own pixels reach over by the width of the samples' filter.
        for (int x = kWidth / 2 + 2; x < kWidth; ++x) {
            const double p = placeOf(x), q = std::min(p / kReach, 1.0);
            // Of rays: the share of the unit disc beyond q (Nusselt).
            const double blocked = (std::acos(q) - q * std::sqrt(1 - q * q)) / kPi;
            EXPECT_NEAR(rays[x], 1 - blocked, 0.02) << p;
            EXPECT_NEAR(taps[x], 1 - blocked, 0.05) << p;
            worst = std::max(worst, std::abs(taps[x] - rays[x]));
        }
        fmt::print("taps and rays differ by {:.3f} at most\n", worst);
        EXPECT_LT(worst, 0.06);
    }
}

TEST_F(TapsTest, GrowsWithItsAmount) {
    const int x = kWidth / 2 + 4;
    EXPECT_NEAR(crease(0, OcclusionMethod::kTaps)[x], 1, 0.01);
    double last = 1;
    for (const float amount : {0.5f, 1.0f, 1.5f}) {
        const double open = crease(amount, OcclusionMethod::kTaps)[x];
        EXPECT_LT(open, last - 0.1) << amount;
        last = open;
    }
    EXPECT_NEAR(crease(5, OcclusionMethod::kTaps)[x], 0, 0.01);
}

TEST_F(TapsTest, OtherFieldsOccludeAsTheSameFieldWould) {
    const auto two = crease(1, OcclusionMethod::kTaps);
    test::TestScene made = scene(1, OcclusionMethod::kTaps);
    made.add(
        made.addField("// bounds[-3, -0.5, -3, 3, 1.5, 3]\n"
                      "float sdf(vec3 p) { return min(p.y, max(p.x, p.y - 1.5)); }"));
    const auto one = openness(made);
    for (int x = kWidth / 2 + 1; x < kWidth; ++x) EXPECT_NEAR(one[x], two[x], 0.02) << placeOf(x);
}

TEST_F(TapsTest, ABlockAboveMakesItDark) {
    for (const double gap : {0.05, 0.2, 0.4}) {
        test::TestScene made = scene(1, OcclusionMethod::kTaps);
        made.add(made.addField(floorField()));
        made.add(made.addField(boxField({-3, static_cast<float>(gap), -3}, {3, 3, 3})));
        Camera& camera = made.scene.cameras[0];
        camera.eye = {0, static_cast<float>(0.5 * gap), 1};
        camera.target = {0, 0, 0};
        camera.fov = 2;
        const double q = gap / kReach, blocked = 1 - q * q;
        EXPECT_NEAR(openness(made)[kWidth / 2], 1 - blocked, 0.12) << gap;
    }
}

TEST_F(TapsTest, MeshesKeepRaysAndTapsSeeFieldsAlone) {
    const auto meshFloor = [](OcclusionMethod method) {
        test::TestScene made = scene(1, method);
        made.add(made.addMesh(makePlane(6, 6)));
        made.add(made.addField(wallField()));
        return draw(made, 1, View::kAo);
    };
    const ImageRgba8 a = meshFloor(OcclusionMethod::kTaps), b = meshFloor(OcclusionMethod::kRays);
    for (int y = 0; y < kHeight; ++y)
        for (int x = kWidth / 2 + 1; x < kWidth; ++x)
            EXPECT_EQ(a.at(x, y)[0], b.at(x, y)[0]) << x << ", " << y;
    test::TestScene made = scene(1, OcclusionMethod::kTaps);
    made.add(made.addField(floorField()));
    made.add(made.addMesh(makeBox({1.5f, 0.75f, 3}))).at = {-1.5f, 0.75f, 0};
    const auto open = openness(made);
    for (int x = kWidth / 2 + 1; x < kWidth; ++x) EXPECT_NEAR(open[x], 1, 0.02);
}

TEST_F(TapsTest, AmbientLightIsThatOfRaysWhereNothingIsInTheWay) {
    const auto light = [](OcclusionMethod method, float tilt) {
        test::TestScene made = scene(1, method);
        made.scene.environment.zenith.rgb = glm::vec3(0.2f);
        made.scene.environment.horizon.rgb = glm::vec3(0.6f);
        made.scene.environment.ground.rgb = glm::vec3(0.1f);
        made.add(made.addField(floorField())).rotate = {0, 0, tilt};
        return column(draw(made, 16), kWidth / 2, true);
    };
    for (const float tilt : {0.0f, 40.0f, 70.0f})
        EXPECT_NEAR(light(OcclusionMethod::kTaps, tilt) / light(OcclusionMethod::kRays, tilt), 1,
                    0.05)
            << tilt;
}

}  // namespace
}  // namespace vitrine
