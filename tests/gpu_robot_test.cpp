// SPDX-License-Identifier: MIT
// What scenes/robot.toml promises: each of its parameters does what it says, as far as a small
// picture tells, its idle animation has no seam, and both finders of first hits see the same robot.
#include <algorithm>
#include <cmath>

#include "gpu_support.hpp"
#include "image/compare.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 160, kHeight = 90;
const std::string kPinhole = "camera.f_stop=0";

LoadedScene robot(const std::vector<std::string>& overrides) {
    Diagnostics diagnostics;
    LoadedScene loaded = loadAll("scenes/robot.toml", overrides, diagnostics);
    diagnostics.throwIfErrors();
    return loaded;
}

/// A rectangle of pixels, first and one beyond last.
struct Part {
    int x0 = 0, y0 = 0, x1 = kWidth, y1 = kHeight;
};

/// Around the place of the picture where a point of the world is seen, in metres.
Part around(const glm::vec3& point, double radius) {
    const Camera camera = robot({}).scene.cameras[0];
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward), to = point - camera.eye;
    const double scale = kWidth * camera.focalLength / 36 / glm::dot(to, forward);
    const double x = 0.5 * kWidth + scale * glm::dot(to, right),
                 y = 0.5 * kHeight - scale * glm::dot(to, up), r = scale * radius;
    return {std::max(0, static_cast<int>(x - r)), std::max(0, static_cast<int>(y - r)),
            std::min(kWidth, static_cast<int>(x + r) + 1),
            std::min(kHeight, static_cast<int>(y + r) + 1)};
}

// Points of the robot and its studio at time 0.
const glm::vec3 kBelly{0, 0.93, 0.3}, kNearBall{1.36, 1.785, 6.76};
const glm::vec3 kForehead{0.1, 2.37, 0.4}, kFace{0.1, 2.1, 0.42}, kWall{0.7, 3.2, -4};
const glm::vec3 kRightCheek{-0.33, 1.84, 0.42}, kLeftCheek{0.5, 1.84, 0.3};

class Picture {
  public:
    Picture(const std::vector<std::string>& overrides, int samples, float time = 0) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = samples;
        request.time = time;
        image_ = test::drawPicture(robot(overrides), Backend::kAuto, request);
    }
    [[nodiscard]] const ImageRgba8& image() const { return image_; }
    /// 0 to 1, as shown or, `linear`, as light that the display gives off.
    [[nodiscard]] glm::dvec3 mean(const Part& part = {}, bool linear = false) const {
        glm::dvec3 sum(0);
        for (int y = part.y0; y < part.y1; ++y)
            for (int x = part.x0; x < part.x1; ++x) {
                const glm::dvec3 c = color(x, y);
                for (int i = 0; i < 3; ++i)
                    sum[i] += linear ? test::linearFromSrgb(255 * c[i]) : c[i];
            }
        return sum / static_cast<double>((part.x1 - part.x0) * (part.y1 - part.y0));
    }
    [[nodiscard]] double brightness(const Part& part = {}) const {
        return glm::dot(mean(part, true), glm::dvec3(0.2126, 0.7152, 0.0722));
    }
    /// The mean square of steps between neighbouring blocks of 3 x 3 pixels, in which noise fades
    /// and sharp edges do not.
    [[nodiscard]] double sharpness(const Part& part) const {
        const auto block = [&](int x, int y) { return mean({x, y, x + 3, y + 3}); };
        double sum = 0;
        int count = 0;
        for (int y = part.y0; y + 6 <= part.y1; ++y)
            for (int x = part.x0; x + 6 <= part.x1; ++x, ++count) {
                const glm::dvec3 a = block(x + 3, y) - block(x, y),
                                 b = block(x, y + 3) - block(x, y);
                sum += glm::dot(a, a) + glm::dot(b, b);
            }
        return sum / count;
    }
    /// How far the light of the eyes spreads along x, pixels: their distance, and a little more.
    [[nodiscard]] double eyes() const {
        double weight = 0, sum = 0, squares = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = kWidth / 4; x < kWidth * 3 / 4; ++x) {
                const glm::dvec3 c = color(x, y);
                if (c.y < 0.93 || c.z < 0.95 || c.z < c.x + 0.1) continue;
                weight += 1, sum += x, squares += x * x;
            }
        return weight < 2 ? 0 : std::sqrt(squares / weight - sum / weight * sum / weight);
    }

  private:
    [[nodiscard]] glm::dvec3 color(int x, int y) const {
        const auto& c = image_.at(x, y);
        return glm::dvec3(c[0], c[1], c[2]) / 255.0;
    }
    ImageRgba8 image_;
};

class RobotTest : public test::GpuTest {};

TEST_F(RobotTest, KeyLightTurns) {
    const auto lit = [](const char* angle) { return Picture({kPinhole, angle}, 4); };
    const Part wall = around(kWall, 0.2);
    const Part right = around(kRightCheek, 0.05), left = around(kLeftCheek, 0.05);
    // The wall is upright: light from above passes along it.
    const Picture above = lit("light.key.polar=5"), level = lit("light.key.polar=75");
    EXPECT_GT(level.brightness(wall), 2 * above.brightness(wall));
    EXPECT_GT(level.brightness(left), 1.5 * above.brightness(left));
    const Picture fromRight = lit("light.key.azimuth=-60"), fromLeft = lit("light.key.azimuth=90");
    EXPECT_GT(fromRight.brightness(right) / fromRight.brightness(left),
              1.5 * fromLeft.brightness(right) / fromLeft.brightness(left));
}

TEST_F(RobotTest, ColoursOfLightAndShell) {
    const Part forehead = around(kForehead, 0.06), wall = around(kWall, 0.2);
    const Picture red({kPinhole, "material.shell.base_color=[0.8,0.05,0.05]"}, 4);
    const Picture blue({kPinhole, "material.shell.base_color=[0.05,0.05,0.8]"}, 4);
    EXPECT_GT(red.mean(forehead).x, 2 * red.mean(forehead).z);
    EXPECT_GT(blue.mean(forehead).z, 2 * blue.mean(forehead).x);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(red.mean(wall)[i], blue.mean(wall)[i], 0.02);
    const glm::dvec3 warm = Picture({kPinhole, "light.key.color=[1,0.5,0.2]"}, 4).mean({}, true),
                     cool = Picture({kPinhole, "light.key.color=[0.2,0.5,1]"}, 4).mean({}, true);
    EXPECT_GT(warm.x / warm.z, 2 * cool.x / cool.z);
}

TEST_F(RobotTest, FocalLengthIsProportionalToWhatIsSeen) {
    const auto eyes = [](int focalLength) {
        return Picture({kPinhole, fmt::format("camera.focal_length={}", focalLength)}, 8).eyes();
    };
    const double wide = eyes(20), half = eyes(90), whole = eyes(180), longest = eyes(200);
    EXPECT_NEAR(whole / half, 2, 0.1);
    EXPECT_NEAR(longest / whole, 200.0 / 180, 0.05);
    EXPECT_LT(wide, 0.35 * half);
}

TEST_F(RobotTest, LensBlursWhatIsOutOfFocus) {
    const Part ball = around(kNearBall, 0.12), face = around(kFace, 0.4);
    const Picture open({"camera.f_stop=1"}, 8), closed({"camera.f_stop=22"}, 8);
    EXPECT_LT(open.sharpness(ball), 0.6 * closed.sharpness(ball));
    EXPECT_GT(open.sharpness(face), 0.8 * closed.sharpness(face));
    // What is sharp now stands before what is not, and its edge mixes with that.
    const Picture near({"camera.f_stop=1", "camera.focus_distance=2.5"}, 8);
    EXPECT_GT(near.sharpness(ball), 1.15 * open.sharpness(ball));
    EXPECT_LT(near.sharpness(face), 0.65 * open.sharpness(face));
}

TEST_F(RobotTest, ExposureAndGammaBrighten) {
    const auto bright = [](const char* setting, const Part& part = {}) {
        return Picture({kPinhole, "render.tone_map=none", setting}, 2).brightness(part);
    };
    // Where nothing is clipped, in proportion.
    const Part wall = around(kWall, 0.2);
    EXPECT_NEAR(
        bright("render.exposure_percent=100", wall) / bright("render.exposure_percent=25", wall), 4,
        0.1);
    EXPECT_GT(bright("render.exposure_percent=400"), 1.5 * bright("render.exposure_percent=100"));
    // v becomes v^(1 / gamma) of what is shown.
    const auto shown = [&](const char* setting) {
        return Picture({kPinhole, "render.tone_map=none", setting}, 2).mean(wall).y;
    };
    const double plain = shown("render.gamma=1");
    EXPECT_NEAR(shown("render.gamma=2"), std::pow(plain, 0.5), 0.02);
    EXPECT_NEAR(shown("render.gamma=0.5"), std::pow(plain, 2.0), 0.02);
}

TEST_F(RobotTest, OcclusionDarkensCreasesAndSubsurfaceLightsShadows) {
    const Part crease = around({1.41, 1.23, -1.12}, 0.05), open = around(kWall, 0.2);
    const auto drawn = [](const char* setting) { return Picture({kPinhole, setting}, 8); };
    const Picture none = drawn("render.ao=0"), much = drawn("render.ao=5");
    const double inCrease = much.brightness(crease) / none.brightness(crease);
    EXPECT_LT(inCrease, 0.8);
    EXPECT_LT(inCrease, 0.8 * much.brightness(open) / none.brightness(open));
    const Picture hard = drawn("render.sss_all=0"), wax = drawn("render.sss_all=1");
    const Part belly = around(kBelly, 0.1);
    EXPECT_GT(wax.brightness(), 1.02 * hard.brightness());
    EXPECT_GE(wax.brightness(belly), hard.brightness(belly));
}

TEST_F(RobotTest, IdleAnimationHasNoSeam) {
    const auto at = [](float time) { return Picture({kPinhole}, 1, time); };
    const Picture first = at(0), seam = at(8);
    EXPECT_LT(compareImages(first.image(), seam.image()).fractionOver, 0.001);
    const double step = compareImages(at(8 - 1 / 24.0f).image(), seam.image()).fractionOver;
    EXPECT_LT(step, 0.03) << "the last picture of the round is far from the first one";
    for (const float time : {0.6f, 2.68f, 3.5f, 5.5f})
        EXPECT_GT(compareImages(first.image(), at(time).image()).fractionOver, 0.01) << time;
}

TEST_F(RobotTest, BothFindersSeeTheSame) {
    const LoadedScene loaded = robot({kPinhole});
    for (const char* camera : {"portrait", "figure", "face"}) {
        PictureRequest raster, trace;
        raster.width = trace.width = 320;
        raster.height = trace.height = 180;
        raster.samples = trace.samples = 1;
        raster.camera = trace.camera = camera;
        trace.primary = Primary::kTrace;
        const ImageRgba8 one = test::drawPicture(loaded, Backend::kFragment, raster);
        const ImageRgba8 other = test::drawPicture(loaded, Backend::kFragment, trace);
        EXPECT_LT(compareImages(one, other).fractionOver, 0.001) << camera;
    }
}

}  // namespace
}  // namespace vitrine
