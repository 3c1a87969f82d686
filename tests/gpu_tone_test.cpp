// SPDX-License-Identifier: MIT
// Tone maps: the picture of an even environment against the curves computed here, in another way
// where there is one.
#include <algorithm>
#include <cmath>

#include "gpu_support.hpp"

namespace vitrine {
namespace {

class ToneTest : public test::GpuTest {
  protected:
    /// The 8-bit colour of light everywhere; the mean of many pixels, so that dither averages out.
    static glm::dvec3 shown(const glm::vec3& light, ToneMap curve, float percent = 100,
                            Backend backend = Backend::kAuto) {
        test::TestScene scene;
        scene.scene.render.toneMap = curve;
        scene.scene.render.exposurePercent = percent;
        Environment& e = scene.scene.environment;
        e.zenith.rgb = e.horizon.rgb = e.ground.rgb = light;
        PictureRequest request;
        request.width = request.height = 16;
        const ImageRgba8 image = test::drawPicture(scene.load(), backend, request);
        glm::dvec3 sum(0);
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                for (int c = 0; c < 3; ++c) sum[c] += image.at(x, y)[static_cast<size_t>(c)];
        return sum / 256.0;
    }
    static double eightBits(double linear) {
        const double c = std::clamp(linear, 0.0, 1.0);
        return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
    }
    /// Degrees, of the largest difference of channels.
    static double hue(const glm::dvec3& c) {
        return glm::degrees(std::atan2(std::sqrt(3.0) * (c.y - c.z), 2 * c.x - c.y - c.z));
    }
};

constexpr std::array kCurves{ToneMap::kFilmic, ToneMap::kAces, ToneMap::kAgx, ToneMap::kReinhard};

TEST_F(ToneTest, GreysFollowThePublishedCurves) {
    for (const double x : {0.0, 0.004, 0.02, 0.09, 0.18, 0.4, 1.0, 2.5, 8.0, 14.0}) {
        SCOPED_TRACE(fmt::format("light {}", x));
        const glm::vec3 light(static_cast<float>(x));
        // The polynomial that Wrensch fitted to the sigmoid, from his article.
        const double e = std::clamp((std::log2(std::max(x, 1e-10)) + 12.47393) / 16.5, 0.0, 1.0);
        double agx = 0;
        for (const double k : {15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.00232})
            agx = agx * e + k;
        // It is 0.004 off at most, more where the 8-bit curve is steep.
        const double dark = x < 0.01 ? 4 : 2;
        EXPECT_NEAR(shown(light, ToneMap::kAgx).x, eightBits(std::pow(std::max(agx, 0.0), 2.2)),
                    dark);
        EXPECT_NEAR(shown(light, ToneMap::kReinhard).x, eightBits(x * (1 + x / 16) / (1 + x)), 0.6);
        const double v = 1.463 * x;
        EXPECT_NEAR(shown(light, ToneMap::kAces).x,
                    eightBits((v * (v + 0.0245786) - 0.000090537) /
                              (v * (0.983729 * v + 0.4329510) + 0.238081)),
                    0.8);
        EXPECT_NEAR(shown(light, ToneMap::kNone).x, eightBits(x), 0.6);
    }
}

TEST_F(ToneTest, KeepMiddleGreyAndNeverFall) {
    for (const ToneMap curve : kCurves)
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(static_cast<int>(curve));
            const double grey =
                test::linearFromSrgb(shown(glm::vec3(0.18f), curve, 100, backend).y);
            EXPECT_GT(grey, 0.15);
            EXPECT_LT(grey, 0.23);
            double before = -1;
            for (float x = 0.001f; x < 1000; x *= 4) {
                const double y = shown(glm::vec3(x), curve, 100, backend).y;
                EXPECT_GE(y, before - 0.1) << x;
                before = y;
            }
            EXPECT_GT(before, 250);
        }
}

TEST_F(ToneTest, AgxKeepsTheHueOfBrightBlueBest) {
    // Much blue light with a bit of green in it: channel by channel, red and green catch up.
    const glm::vec3 light(0.1f, 0.5f, 3.0f);
    const double straight = hue(glm::dvec3(light));
    const auto turn = [&](ToneMap curve) {
        const glm::dvec3 c = shown(light, curve);
        const double d = std::abs(
            hue({test::linearFromSrgb(c.x), test::linearFromSrgb(c.y), test::linearFromSrgb(c.z)}) -
            straight);
        return std::min(d, 360 - d);
    };
    for (const ToneMap curve : kCurves)
        RecordProperty(fmt::format("turn{}", static_cast<int>(curve)),
                       fmt::format("{:.1f}", turn(curve)));
    EXPECT_LT(turn(ToneMap::kAgx), turn(ToneMap::kFilmic));
}

TEST_F(ToneTest, PercentMultipliesTheLight) {
    for (const float percent : {0.0f, 50.0f, 250.0f})
        EXPECT_NEAR(shown(glm::vec3(0.3f), ToneMap::kNone, percent).y, eightBits(0.003 * percent),
                    0.6);
}

}  // namespace
}  // namespace vitrine
