// SPDX-License-Identifier: MIT
// The lens as a filter over one sharp sample, against the thin lens of many samples and against the
// formula of the circle of confusion.
//
// A chart of small balls that glow at several distances. Each becomes a disc whose diameter is told
// by the second moment of its light: a disc of diameter D varies by D^2 / 16 along an axis, and
// what the ball and the pixels add is measured with a pinhole.
#include <cmath>

#include "gpu_spot.hpp"
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kSide = 128;
constexpr double kFocus = 2, kFocalLength = 50, kFStop = 0.25, kSensor = 36;
constexpr double kPixels = kSide * kFocalLength / kSensor;  // of an angle of one radian
constexpr double kBallPixels = 4;
constexpr int kSamples = 128;  // of the thin lens

/// Diameter in pixels after Potmesil & Chakravarty (1981): c = A |d - df| / d * f / (df - f) on the
/// sensor, which stands f df / (df - f) behind the lens.
double formula(double distance) {
    const double f = kFocalLength / 1000, aperture = f / kFStop;
    const double circle = aperture * std::abs(distance - kFocus) / distance * f / (kFocus - f);
    const double sensorDistance = f * kFocus / (kFocus - f);
    return circle / sensorDistance * kPixels;
}

using test::Spot;

Spot measure(const ImageRgba32f& image) {
    return test::measureSpot(kSide, [&](int x, int y) { return double{image.at(x, y)[0]}; });
}

double diameter(const Spot& blurred, const Spot& sharp) {
    const glm::dvec2 own = blurred.variance - sharp.variance;
    return 4 * std::sqrt(std::max(0.0, (own.x + own.y) / 2));
}

class FocusTest : public test::GpuTest {
  protected:
    static Material glow(float radiance) {
        Material m;
        m.emission.rgb = glm::vec3(radiance);
        m.baseColor.rgb = glm::vec3(0);
        m.specular = 0;
        return m;
    }
    static test::TestScene chart() {
        test::TestScene scene;
        Camera& camera = scene.scene.cameras[0];
        camera.fov = 0;
        camera.focalLength = kFocalLength;
        camera.fStop = kFStop;
        camera.focusDistance = kFocus;
        camera.eye = {1, 2, 3};
        camera.target = {0.2f, 1.7f, 0.4f};
        return scene;
    }
    /// A ball at `distance` along the axis of a tilted camera.
    static test::TestScene ballAt(double distance) {
        test::TestScene scene = chart();
        const Camera& camera = scene.scene.cameras[0];
        const double radius = kBallPixels / 2 * distance / kPixels;
        const glm::vec3 axis = glm::normalize(camera.target - camera.eye);
        const glm::vec3 at = camera.eye + static_cast<float>(distance) * axis;
        scene
            .add(scene.addMesh(makeSphere(static_cast<float>(radius), 32)),
                 scene.addMaterial(glow(10)))
            .at = at;
        return scene;
    }
    static ImageRgba32f draw(test::TestScene& scene, LensBlur lens, int samples,
                             Backend backend = Backend::kAuto) {
        scene.scene.cameras[0].lens = lens;
        PictureRequest request;
        request.width = request.height = kSide;
        request.samples = samples;
        const LoadedScene loaded = scene.load();
        Renderer renderer(loaded, backend, false);
        return renderer.drawLayers(request, nullptr).light;
    }
    /// Of two pictures: the light that is elsewhere, as a part of all.
    static double misplaced(const ImageRgba32f& a, const ImageRgba32f& b) {
        double apart = 0, all = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                apart += std::abs(a.at(x, y)[0] - b.at(x, y)[0]);
                all += a.at(x, y)[0] + b.at(x, y)[0];
            }
        return apart / all;
    }
};

TEST_F(FocusTest, BlursAsWideAsTheThinLensAndTheFormula) {
    fmt::print("{:>8} {:>9} {:>10} {:>8}   diameters in pixels\n", "m", "formula", "thin lens",
               "filter");
    for (const double distance : {0.5, 0.7, 1.0, 1.5, 1.9, 2.0, 2.2, 3.0, 4.0, 20.0}) {
        SCOPED_TRACE(fmt::format("{} m", distance));
        test::TestScene scene = ballAt(distance);
        const Spot thin = measure(draw(scene, LensBlur::kSampled, kSamples));
        const Spot filter = measure(draw(scene, LensBlur::kFilter, 1));
        scene.scene.cameras[0].fStop = 0;
        const Spot sharp = measure(draw(scene, LensBlur::kSampled, 16));
        const Spot sharpOne = measure(draw(scene, LensBlur::kSampled, 1));
        const double expected = formula(distance);
        const double traced = diameter(thin, sharp), filtered = diameter(filter, sharpOne);
        fmt::print("{:8.1f} {:9.2f} {:10.2f} {:8.2f}\n", distance, expected, traced, filtered);
        EXPECT_NEAR(traced, expected, 0.7);
        EXPECT_NEAR(filtered, expected, 1);
        EXPECT_NEAR(filtered, traced, 1);
        // It only moves light.
        EXPECT_NEAR(filter.light / sharpOne.light, 1, 0.05);
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_NEAR(filter.middle[axis], sharpOne.middle[axis], 0.2);
    }
}

TEST_F(FocusTest, BackEndsAgree) {
    test::TestScene scene = ballAt(0.9);
    EXPECT_LT(misplaced(draw(scene, LensBlur::kFilter, 1, Backend::kFragment),
                        draw(scene, LensBlur::kFilter, 1, Backend::kCompute)),
              1e-4);
}

TEST_F(FocusTest, BladesMakeTheSamePolygonsBothWaysRound) {
    for (const double distance : {1.0, 5.0})
        for (const int blades : {3, 5}) {
            SCOPED_TRACE(fmt::format("{} m, {} blades", distance, blades));
            test::TestScene scene = ballAt(distance);
            scene.scene.cameras[0].apertureBlades = blades;
            const ImageRgba32f thin = draw(scene, LensBlur::kSampled, kSamples);
            const ImageRgba32f filter = draw(scene, LensBlur::kFilter, 1);
            // The same polygon upside down misplaces a third of a triangle's light.
            EXPECT_LT(misplaced(thin, filter), 0.15);
        }
}

/// A bright card that fills the left half at `front`, before one that fills all at `back`.
TEST_F(FocusTest, LaysTheNearOverTheFarAndTheSharpOverTheBlurred) {
    for (const auto& [front, back] : {std::pair(1.0, kFocus), {kFocus, 6.0}, {1.2, 6.0}}) {
        SCOPED_TRACE(fmt::format("{} m before {} m", front, back));
        test::TestScene scene = chart();
        Camera& camera = scene.scene.cameras[0];
        camera.eye = {0, 0, 0};
        camera.target = {0, 0, -2};
        const auto card = [&](double distance, float left, float right, float radiance) {
            const auto d = static_cast<float>(distance);
            const int shape =
                scene.addMesh({{left, -d, -d}, {right, -d, -d}, {right, d, -d}, {left, d, -d}},
                              {{0, 1, 2}, {0, 2, 3}});
            scene.add(shape, scene.addMaterial(glow(radiance)));
        };
        card(front, -static_cast<float>(front), 0, 0.8f);
        card(back, -static_cast<float>(back), static_cast<float>(back), 0.2f);
        const ImageRgba32f thin = draw(scene, LensBlur::kSampled, kSamples);
        const ImageRgba32f filter = draw(scene, LensBlur::kFilter, 1);
        double worst = 0, sum = 0;
        for (int x = 0; x < kSide; ++x) {
            // Far from the upper and lower edges, means over rows.
            double a = 0, b = 0;
            for (int y = kSide / 2 - 16; y < kSide / 2 + 16; ++y) {
                a += thin.at(x, y)[0] / 32;
                b += filter.at(x, y)[0] / 32;
            }
            worst = std::max(worst, std::abs(a - b));
            sum += std::abs(a - b) / kSide;
        }
        fmt::print("{} m before {} m: off by {:.3f} at most, {:.4f} on average\n", front, back,
                   worst, sum);
        // One sample has steps where 128 have edges that are two pixels wide.
        EXPECT_LT(worst, 0.1);
        EXPECT_LT(sum, 0.006);
    }
}

TEST_F(FocusTest, LeavesASharpPictureAlone) {
    test::TestScene scene = ballAt(kFocus);
    const ImageRgba32f filter = draw(scene, LensBlur::kFilter, 1);
    scene.scene.cameras[0].fStop = 0;
    EXPECT_LT(misplaced(draw(scene, LensBlur::kFilter, 1), filter), 1e-5);
}

}  // namespace
}  // namespace vitrine
