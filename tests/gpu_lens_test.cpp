// SPDX-License-Identifier: MIT
// The lens against the formula of the circle of confusion.
//
// A small ball that glows, out of focus, becomes a disc. Its size is measured by its second moment,
// which is exact whatever the noise of single pixels: a disc of diameter D varies by D^2 / 16 along
// each axis, and the ball itself, the pixels and the samples' filter add their own variances.
#include <cmath>

#include "gpu_spot.hpp"
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kSide = 64;
constexpr double kFocus = 2, kFocalLength = 50, kFStop = 0.25;
// On the picture's axis, a distance and how wide a ball is in pixels there.
constexpr double kPixels = kSide * kFocalLength / 36, kBallPixels = 4;
constexpr double kFilterVariance = 1.0 / 12 + 1.0 / 6;  // of a pixel and of the tent over it

using test::Spot;

class LensTest : public test::GpuTest {
  protected:
    /// A ball at `distance` along the axis whose blurred picture is about 0.25 bright. The view is
    /// tilted, so that axes of the world and of the camera differ.
    static test::TestScene ballAt(double distance, double spotPixels) {
        test::TestScene scene;
        const double radius = kBallPixels / 2 * distance / kPixels;
        Material glow;
        glow.emission.rgb = glm::vec3(1);
        glow.emissionStrength =
            static_cast<float>(0.25 * std::max(1.0, std::pow(spotPixels / kBallPixels, 2)));
        glow.baseColor.rgb = glm::vec3(0);
        glow.specular = 0;
        Camera& camera = scene.scene.cameras[0];
        camera.fov = 0;
        camera.focalLength = kFocalLength;
        camera.fStop = kFStop;
        camera.focusDistance = kFocus;
        camera.eye = {1, 2, 3};
        camera.target = {0.2f, 1.7f, 0.4f};
        const glm::vec3 axis = glm::normalize(camera.target - camera.eye);
        Node& node = scene.add(scene.addMesh(makeSphere(static_cast<float>(radius), 32)),
                               scene.addMaterial(glow));
        node.at = camera.eye + static_cast<float>(distance) * axis;
        return scene;
    }
    static ImageRgba8 draw(const test::TestScene& scene, int samples,
                           Backend backend = Backend::kAuto) {
        PictureRequest request;
        request.width = request.height = kSide;
        request.samples = samples;
        return test::drawPicture(scene.load(), backend, request);
    }
    static Spot measure(const ImageRgba8& image) {
        return test::measureSpot(kSide, [&](int x, int y) {
            // The dither lifts black by up to a step.
            const uint8_t step = image.at(x, y)[0];
            return step <= 1 ? 0.0 : test::linearFromSrgb(step);
        });
    }
    /// Of the disc alone.
    static double diameter(const Spot& spot, int axis) {
        const double own = kBallPixels * kBallPixels / 16 + kFilterVariance;
        return 4 * std::sqrt(std::max(0.0, spot.variance[axis] - own));
    }
    /// The circle of confusion in pixels: the lens's diameter seen from the point in focus.
    static double formula(double distance) {
        const double diameter = kFocalLength / kFStop / 1000;
        return diameter * std::abs(distance - kFocus) / (distance * kFocus) * kPixels;
    }
};

TEST_F(LensTest, BlursAsTheFormulaSays) {
    for (const Backend backend : test::kBackends)
        for (const double distance : {0.45, 0.7, 1.0, 1.5, 4.0, 20.0}) {
            SCOPED_TRACE(test::nameOf(backend) + fmt::format(", {} m", distance));
            const double expected = formula(distance);
            const Spot spot = measure(draw(ballAt(distance, expected), 256, backend));
            for (int axis = 0; axis < 2; ++axis) {
                EXPECT_NEAR(diameter(spot, axis), expected, 0.7);
                EXPECT_NEAR(spot.middle[axis], (kSide - 1) / 2.0, 0.3);
            }
        }
}

TEST_F(LensTest, ShowsWhatIsInFocusAsAPinholeDoes) {
    for (const bool target : {false, true}) {
        test::TestScene scene = ballAt(kFocus, 0);
        Camera& camera = scene.scene.cameras[0];
        if (target) {
            camera.focusDistance = 0;
            scene.scene.nodes[0].at = camera.target;
        }
        const ImageRgba8 lens = draw(scene, 64);
        camera.fStop = 0;
        const ImageRgba8 pinhole = draw(scene, 64);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                EXPECT_NEAR(test::linearFromSrgb(lens.at(x, y)[0]),
                            test::linearFromSrgb(pinhole.at(x, y)[0]), 0.03);
    }
}

TEST_F(LensTest, BladesMakePolygons) {
    const double distance = 0.6, round = formula(distance);
    for (const int blades : {3, 4, 6}) {
        SCOPED_TRACE(fmt::format("{} blades", blades));
        test::TestScene scene = ballAt(distance, round);
        scene.scene.cameras[0].apertureBlades = blades;
        const Spot spot = measure(draw(scene, 256));
        // Of a polygon with its corners on the circle, against the circle's D^2 / 16.
        const double share = std::sqrt((2 + std::cos(2 * kPi / static_cast<float>(blades))) / 3);
        for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(diameter(spot, axis), round * share, 0.7);
    }
}

TEST_F(LensTest, OneSampleLooksThroughTheMiddle) {
    test::TestScene scene = ballAt(0.5, 0);
    const ImageRgba8 lens = draw(scene, 1);
    scene.scene.cameras[0].fStop = 0;
    EXPECT_EQ(lens.pixels, draw(scene, 1).pixels);
}

}  // namespace
}  // namespace vitrine
