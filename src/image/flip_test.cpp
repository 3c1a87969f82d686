// SPDX-License-Identifier: MIT
// Answers known on paper, and properties; flip_reference_test.cpp compares pixel by pixel.
#include "image/flip.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "base/error.hpp"

namespace vitrine {
namespace {

using Rgb = std::array<uint8_t, 3>;

ImageRgba8 paint(int width, int height, const std::function<Rgb(int, int)>& color) {
    ImageRgba8 image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb c = color(x, y);
            std::copy(c.begin(), c.end(), image.at(x, y).begin());
            image.at(x, y)[3] = 255;
        }
    return image;
}

ImageRgba8 uniform(const Rgb& color, int width = 16, int height = 12) {
    return paint(width, height, [&](int, int) { return color; });
}

ImageRgba8 noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    return paint(width, height, [&](int, int) {
        return Rgb{static_cast<uint8_t>(random()), static_cast<uint8_t>(random()),
                   static_cast<uint8_t>(random())};
    });
}

/// White right of `edge`, black left of it.
ImageRgba8 step(double edge) {
    return paint(64, 48, [&](int x, int) {
        const double covered = std::clamp(x + 1.0 - edge, 0.0, 1.0);
        const auto v = static_cast<uint8_t>(std::lround(255.0 * covered));
        return Rgb{v, v, v};
    });
}

TEST(Flip, EqualPicturesAreExactlyZero) {
    const ImageRgba8 a = noise(40, 30, 3);
    const FlipResult result = flip(a, a);
    EXPECT_EQ(result.mean, 0.0);
    EXPECT_TRUE(std::all_of(result.map.pixels.begin(), result.map.pixels.end(),
                            [](float v) { return v == 0.0f; }));
}

/// Without edges only colour counts, and the formulas can be worked out by hand. Black to white is
/// not 1: of all pairs that a screen can show, green to blue is the farthest.
TEST(Flip, UniformPairsAsOnPaper) {
    struct Pair {
        Rgb a, b;
        double error;
    };
    for (const Pair& p :
         {Pair{{0, 0, 0}, {255, 255, 255}, 0.967380}, Pair{{0, 255, 0}, {0, 0, 255}, 1.0},
          Pair{{255, 0, 0}, {0, 255, 0}, 0.986662},
          Pair{{200, 150, 100}, {100, 150, 200}, 0.855308},
          Pair{{100, 100, 100}, {150, 150, 150}, 0.463669},
          Pair{{128, 128, 128}, {138, 128, 128}, 0.125676},
          Pair{{128, 128, 128}, {129, 129, 129}, 0.029855}, Pair{{0, 0, 0}, {0, 0, 1}, 0.003704}}) {
        const FlipResult result = flip(uniform(p.a), uniform(p.b));
        EXPECT_NEAR(result.mean, p.error, 2e-4);
        for (const float v : result.map.pixels) ASSERT_NEAR(v, p.error, 2e-4);
    }
}

TEST(Flip, OrderDoesNotMatter) {
    const ImageRgba8 a = noise(33, 21, 4), b = step(20.0), c = step(23.0);
    EXPECT_EQ(flip(b, c).map, flip(c, b).map);
    EXPECT_EQ(flip(a, uniform({90, 20, 10}, 33, 21)).map,
              flip(uniform({90, 20, 10}, 33, 21), a).map);
}

TEST(Flip, TurnsWithThePicture) {
    const ImageRgba8 a = noise(18, 25, 5), b = noise(18, 25, 6);
    const auto turned = [](const ImageRgba8& image) {
        return paint(image.height, image.width, [&](int x, int y) {
            const auto p = image.at(y, x);
            return Rgb{p[0], p[1], p[2]};
        });
    };
    const ImageMap upright = flip(a, b).map, lying = flip(turned(a), turned(b)).map;
    for (int y = 0; y < upright.height; ++y)
        for (int x = 0; x < upright.width; ++x)
            ASSERT_NEAR(upright.at(x, y)[0], lying.at(y, x)[0], 1e-4);
}

TEST(Flip, GrowsWithNoise) {
    const ImageRgba8 grey = uniform({120, 120, 120}, 64, 48);
    double before = 0.0;
    for (const int amplitude : {2, 5, 10, 20, 40, 80}) {
        std::mt19937 random(7);
        const ImageRgba8 noisy = paint(64, 48, [&](int, int) {
            const int range = 2 * amplitude + 1;
            const auto v =
                static_cast<uint8_t>(120 - amplitude + static_cast<int>(random() % range));
            return Rgb{v, v, v};
        });
        const double mean = flip(grey, noisy).mean;
        EXPECT_GT(mean, 1.1 * before) << amplitude;
        before = mean;
    }
}

TEST(Flip, GrowsWithShift) {
    double before = 0.0;
    for (const double shift : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0}) {
        const double mean = flip(step(24.0), step(24.0 + shift)).mean;
        EXPECT_GT(mean, 1.1 * before) << shift;
        before = mean;
    }
}

TEST(Flip, GrowsWithBlur) {
    const ImageRgba8 sharp = step(32.0);
    double before = 0.0;
    for (const int radius : {1, 2, 4, 8}) {
        const ImageRgba8 blurred = paint(64, 48, [&](int x, int) {
            const double covered = std::clamp((x + 0.5 - 32.0) / (2.0 * radius) + 0.5, 0.0, 1.0);
            const auto v = static_cast<uint8_t>(std::lround(255.0 * covered));
            return Rgb{v, v, v};
        });
        const double mean = flip(sharp, blurred).mean;
        EXPECT_GT(mean, 1.1 * before) << radius;
        before = mean;
    }
}

/// From farther away the same pixels are smaller. A checkerboard of black and white becomes the
/// grey of half its light, which is 188 in sRGB.
TEST(Flip, FineDifferencesFadeWithDistance) {
    const ImageRgba8 checker = paint(64, 48, [](int x, int y) {
        return (x + y) % 2 == 0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
    });
    const ImageRgba8 grey = uniform({188, 188, 188}, 64, 48);
    float checkerBefore = 1.0f, shiftBefore = 1.0f;
    for (const float pixelsPerDegree : {15.0f, 30.0f, 67.0f, 134.0f}) {
        const float ofChecker = flip(grey, checker, pixelsPerDegree).map.at(32, 24)[0];
        const float ofShift = flip(step(24.0), step(25.0), pixelsPerDegree).map.at(24, 24)[0];
        EXPECT_LT(ofChecker, checkerBefore) << pixelsPerDegree;
        EXPECT_LT(ofShift, shiftBefore) << pixelsPerDegree;
        checkerBefore = ofChecker;
        shiftBefore = ofShift;
    }
    EXPECT_LT(checkerBefore, 0.03f);
}

/// The feature part: a lone dot is a worse error than the same error in colour alone would be.
TEST(Flip, NewPointsWeighMoreThanTheirColour) {
    const ImageRgba8 grey = uniform({128, 128, 128}, 41, 41);
    ImageRgba8 firefly = grey;
    firefly.at(20, 20)[0] = firefly.at(20, 20)[1] = firefly.at(20, 20)[2] = 255;
    const FlipResult result = flip(grey, firefly);
    EXPECT_GT(result.map.at(20, 20)[0], 0.3f);
    EXPECT_EQ(result.map.at(0, 0)[0], 0.0f);
    EXPECT_EQ(std::max_element(result.map.pixels.begin(), result.map.pixels.end()) -
                  result.map.pixels.begin(),
              20 * 41 + 20);
}

TEST(Flip, IgnoresAlpha) {
    ImageRgba8 a = noise(9, 9, 8), b = a;
    for (size_t i = 3; i < b.pixels.size(); i += 4) b.pixels[i] = 0;
    EXPECT_EQ(flip(a, b).mean, 0.0);
}

TEST(Flip, DoesNotDependOnThreads) {
    const ImageRgba8 a = noise(97, 61, 9), b = noise(97, 61, 10);
    const FlipResult many = flip(a, b);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const FlipResult single = flip(a, b);
    EXPECT_EQ(many.map, single.map);
    EXPECT_EQ(many.mean, single.mean);
}

TEST(Flip, StaysInRangeAndHandlesTinyPictures) {
    for (const int side : {1, 2, 3}) {
        const FlipResult result = flip(uniform({0, 0, 0}, side, 1), noise(side, 1, 11));
        for (const float v : result.map.pixels) {
            EXPECT_GE(v, 0.0f);
            EXPECT_LE(v, 1.0f);
        }
    }
    EXPECT_EQ(flip({}, {}).mean, 0.0);
    EXPECT_THROW(flip(ImageRgba8(2, 3), ImageRgba8(3, 2)), InputError);
}

}  // namespace
}  // namespace vitrine
