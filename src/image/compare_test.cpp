// SPDX-License-Identifier: MIT
#include "image/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/error.hpp"

namespace vitrine {
namespace {

ImageRgba8 noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    ImageRgba8 image(width, height);
    // Away from 0 and 255, so that the tests can add and subtract.
    for (uint8_t& value : image.pixels) value = static_cast<uint8_t>(50 + random() % 150);
    return image;
}

TEST(Compare, EqualPicturesAreExactlyEqual) {
    const ImageRgba8 a = noise(31, 17, 1);
    const Comparison c = compareImages(a, a, 0);
    EXPECT_EQ(c.rmse, 0.0);
    EXPECT_EQ(c.psnr, std::numeric_limits<double>::infinity());
    EXPECT_EQ(c.flipMean, 0.0);
    EXPECT_EQ(c.maxDifference, 0.0);
    EXPECT_EQ(c.pixels, 31u * 17u);
    EXPECT_EQ(c.pixelsOver, 0u);
    EXPECT_EQ(c.fractionOver, 0.0);
}

TEST(Compare, EmptyPicturesAreEqual) {
    const Comparison c = compareImages({}, {});
    EXPECT_EQ(c.pixels, 0u);
    EXPECT_EQ(c.fractionOver, 0.0);
    EXPECT_TRUE(std::isinf(c.psnr));
}

/// One channel of one pixel, off by 6, up or down: seen at a tolerance of 5, not at 6.
TEST(Compare, CountsAPixelBeyondTheTolerance) {
    const ImageRgba8 a = noise(20, 10, 2);
    for (const int offset : {6, -6})
        for (size_t channel = 0; channel < 4; ++channel) {
            ImageRgba8 b = a;
            b.at(19, 9)[channel] = static_cast<uint8_t>(b.at(19, 9)[channel] + offset);
            const Comparison at5 = compareImages(a, b, 5);
            EXPECT_EQ(at5.pixelsOver, 1u) << "channel " << channel;
            EXPECT_DOUBLE_EQ(at5.fractionOver, 1.0 / 200.0);
            EXPECT_DOUBLE_EQ(at5.maxDifference, 6.0 / 255.0);
            EXPECT_EQ(compareImages(a, b, 6).pixelsOver, 0u) << "channel " << channel;
        }
}

TEST(Compare, DefaultToleranceIsFive) {
    const ImageRgba8 a(1, 1, {100, 100, 100, 255});
    EXPECT_EQ(compareImages(a, ImageRgba8(1, 1, {100, 105, 100, 255})).pixelsOver, 0u);
    EXPECT_EQ(compareImages(a, ImageRgba8(1, 1, {100, 106, 100, 255})).pixelsOver, 1u);
}

/// Several channels off make one pixel, not several.
TEST(Compare, CountsPixelsNotChannels) {
    const ImageRgba8 a(2, 1, {10, 10, 10, 255, 10, 10, 10, 255});
    const ImageRgba8 b(2, 1, {30, 30, 30, 0, 10, 10, 10, 255});
    EXPECT_EQ(compareImages(a, b).pixelsOver, 1u);
}

TEST(Compare, RmseAndPsnrByHand) {
    // 2 pixels x 3 channels; squares 3^2 + 4^2 + 5^2 = 50 over 6; alpha does not enter.
    const ImageRgba8 a(2, 1, {10, 20, 30, 255, 40, 50, 60, 255});
    const ImageRgba8 b(2, 1, {13, 16, 30, 200, 40, 50, 65, 255});
    const Comparison c = compareImages(a, b);
    EXPECT_DOUBLE_EQ(c.rmse, std::sqrt(50.0 / 6.0) / 255.0);
    EXPECT_NEAR(c.psnr, 38.9226, 1e-4);  // 10 log10(255^2 * 6 / 50)
    EXPECT_DOUBLE_EQ(c.maxDifference, 55.0 / 255.0);

    const ImageRgba8 black(4, 4), white(4, 4, std::vector<uint8_t>(64, 255));
    EXPECT_DOUBLE_EQ(compareImages(black, white).rmse, 1.0);
    EXPECT_DOUBLE_EQ(compareImages(black, white).psnr, 0.0);
}

/// What a pixel count at tolerance 5 cannot see, FLIP and RMSE do.
TEST(Compare, SmallBiasEverywhereIsMeasured) {
    const ImageRgba8 a = noise(32, 32, 3);
    ImageRgba8 b = a;
    for (uint8_t& value : b.pixels) value = static_cast<uint8_t>(value + 4);
    const Comparison c = compareImages(a, b);
    EXPECT_EQ(c.pixelsOver, 0u);
    EXPECT_NEAR(c.rmse, 4.0 / 255.0, 1e-12);
    EXPECT_GT(c.flipMean, 0.03);
}

TEST(Compare, RefusesDifferentSizes) {
    EXPECT_THROW(compareImages(ImageRgba8(4, 3), ImageRgba8(3, 4)), InputError);
    EXPECT_THROW(compareImages(ImageRgba8(4, 3), ImageRgba8(4, 4)), InputError);
}

TEST(Compare, LinearPicturesByTheirLight) {
    ImageRgba32f a(8, 4), b(8, 4);
    for (size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] = b.pixels[i] = i % 4 == 3 ? 1 : 6;
    b.at(3, 2)[1] = 10;  // far above what a screen shows
    const Comparison bright = compareLinear(a, b);
    EXPECT_NEAR(bright.rmse, 4 / std::sqrt(3.0 * 32), 1e-9);
    EXPECT_NEAR(bright.psnr, -20 * std::log10(bright.rmse), 1e-9);
    EXPECT_EQ(bright.maxDifference, 4);
    EXPECT_EQ(bright.flipMean, 0) << "both are white";
    EXPECT_EQ(bright.pixelsOver, 0u);
    b.at(3, 2)[1] = 0.5f;
    EXPECT_EQ(compareLinear(a, b).pixelsOver, 1u);
    EXPECT_GT(compareLinear(a, b).flipMean, 0);
    for (const float broken :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        b.at(3, 2)[1] = broken;
        const Comparison c = compareLinear(a, b);
        EXPECT_EQ(c.pixelsNotFinite, 1u);
        EXPECT_EQ(c.rmse, 0);
        EXPECT_GE(c.pixelsOver, 1u);
    }
}

TEST(Compare, SrgbFromLinearIsTheStandardsCurve) {
    ImageRgba32f image(6, 1);
    const float values[6] = {-1, 0, 0.0031308f, 0.2158605f, 1, 7};
    const int expected[6] = {0, 0, 10, 128, 255, 255};
    for (int x = 0; x < 6; ++x) image.at(x, 0)[0] = image.at(x, 0)[3] = values[x];
    const ImageRgba8 srgb = srgbFromLinear(image);
    for (int x = 0; x < 6; ++x) EXPECT_EQ(srgb.at(x, 0)[0], expected[x]) << x;
    EXPECT_EQ(srgb.at(3, 0)[3], 55) << "alpha has no curve";
}

}  // namespace
}  // namespace vitrine
