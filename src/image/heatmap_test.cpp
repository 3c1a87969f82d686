// SPDX-License-Identifier: MIT
#include "image/heatmap.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace vitrine {
namespace {

float luma(const glm::vec3& c) {
    return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

TEST(Heatmap, MagmaGrowsLighterAllTheWay) {
    for (int i = 1; i <= 100; ++i)
        EXPECT_GT(luma(magma(static_cast<float>(i) / 100.0f)),
                  luma(magma(static_cast<float>(i - 1) / 100.0f)))
            << i;
}

/// Entries of the published 256-colour table, which the fit follows to about 1 %.
TEST(Heatmap, MagmaFollowsItsTable) {
    const auto expectNear = [](const glm::vec3& a, const glm::vec3& b) {
        EXPECT_LT(glm::length(a - b), 0.03f) << a.x << ' ' << a.y << ' ' << a.z;
    };
    expectNear(magma(0.0f), {0.001462f, 0.000466f, 0.013866f});
    expectNear(magma(128.0f / 255.0f), {0.716387f, 0.214982f, 0.475290f});
    expectNear(magma(1.0f), {0.987053f, 0.991438f, 0.749504f});
}

TEST(Heatmap, HeatGoesFromBlueOverGreenToRed) {
    EXPECT_GT(heat(0.15f).z, 2.0f * heat(0.15f).x);
    EXPECT_GT(heat(0.5f).y, 2.0f * heat(0.5f).x);
    EXPECT_GT(heat(0.85f).x, 2.0f * heat(0.85f).z);
    EXPECT_NE(heat(1.0f), heat(5.0f / 6.0f));
}

TEST(Heatmap, ClampsAndShowsWhatIsNotANumber) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const auto scale : {magma, heat}) {
        EXPECT_EQ(scale(-kInfinity), scale(0.0f));
        EXPECT_EQ(scale(kInfinity), scale(1.0f));
        const ImageMap map(3, 1, {0.0f, 1.0f, std::numeric_limits<float>::quiet_NaN()});
        const ImageRgba8 image = colorize(map, scale);
        for (int x = 0; x < 2; ++x)
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(image.at(x, 0)[channel] / 255.0f, scale(map.at(x, 0)[0])[channel],
                            0.5f / 255.0f + 1e-6f);
        EXPECT_EQ(std::vector<uint8_t>(image.at(2, 0).begin(), image.at(2, 0).end()),
                  (std::vector<uint8_t>{255, 0, 255, 255}));
        EXPECT_EQ(image.at(0, 0)[3], 255);
    }
}

}  // namespace
}  // namespace vitrine
