// SPDX-License-Identifier: MIT
#include "pack/sky_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <random>

#include "pack/atmosphere.hpp"

namespace vitrine {
namespace {

ImageRgba32f constantPicture(int width, int height, float radiance) {
    ImageRgba32f picture(width, height);
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = i % 4 == 3 ? 1 : radiance;
    return picture;
}

void paint(ImageRgba32f& picture, int x, int y, float radiance) {
    for (size_t c = 0; c < 3; ++c) picture.at(x, y)[c] = radiance;
}

/// A dim picture with bright spots, some of them at its borders.
ImageRgba32f spottedPicture(int width, int height, uint32_t seed) {
    std::mt19937 random(seed);
    ImageRgba32f picture = constantPicture(width, height, 0.1f);
    for (int i = 0; i < 12; ++i)
        paint(picture, static_cast<int>(random() % static_cast<unsigned>(width)),
              static_cast<int>(random() % static_cast<unsigned>(height)),
              static_cast<float>(10 + random() % 200));
    paint(picture, 0, height / 2, 300);
    paint(picture, width / 3, 0, 300);
    paint(picture, width - 1, height - 1, 300);
    return picture;
}

double solidAngle(int row, int rows) {
    return (std::cos(static_cast<double>(kPi) * row / rows) -
            std::cos(static_cast<double>(kPi) * (row + 1) / rows)) *
           kPi / rows;
}

struct Choice {
    int x = 0, y = 0;
    double probability = 0;
};

/// Down the tree as the shader goes (shaders/scene/sky.glsl).
Choice choose(const SkyTree& tree, double ux, double uy) {
    Choice c;
    size_t first = 0;
    int columns = 1;
    for (int level = 0; level < tree.levels; ++level) {
        const glm::dvec4 node(
            tree.nodes[first + static_cast<size_t>(c.y) * columns + static_cast<size_t>(c.x)]);
        const double left = node.x + node.z, share = left / (left + node.y + node.w);
        const bool right = ux >= share;
        ux = right ? (ux - share) / (1 - share) : ux / share;
        const glm::dvec2 column = right ? glm::dvec2(node.y, node.w) : glm::dvec2(node.x, node.z);
        const double upper = column.x / (column.x + column.y);
        const bool lower = uy >= upper;
        uy = lower ? (uy - upper) / (1 - upper) : uy / upper;
        c = {2 * c.x + right, 2 * c.y + lower, lower ? column.y : column.x};
        first += level == 0 ? 1 : static_cast<size_t>(columns) * (columns / 2);
        columns *= 2;
    }
    return c;
}

TEST(SkyMap, TreesChooseEachCellAsOftenAsTheySay) {
    for (const auto& [width, height] : {std::pair(32, 16), {37, 11}, {2, 1}, {1, 1}}) {
        const SkyMap map = makeSkyMap(spottedPicture(width, height, 1));
        for (const SkyTree* tree : {&map.whole, &map.bright}) {
            if (tree->levels == 0) continue;
            const int columns = 1 << tree->levels, rows = columns / 2;
            std::vector<double> chosen(static_cast<size_t>(columns) * rows), said(chosen.size());
            constexpr int kPoints = 400000;
            std::mt19937 random(5);
            std::uniform_real_distribution<double> uniform(0, 1);
            for (int i = 0; i < kPoints; ++i) {
                const Choice c = choose(*tree, uniform(random), uniform(random));
                ASSERT_LT(c.y, rows);
                const size_t cell = static_cast<size_t>(c.y) * columns + c.x;
                chosen[cell] += 1;
                said[cell] = c.probability * kPoints;
            }
            // Pearson's statistic over the cells that are likely enough: of random points it is the
            // number of cells, give or take the root of twice that.
            double chiSquare = 0;
            int cells = 0;
            for (size_t i = 0; i < chosen.size(); ++i) {
                if (said[i] < 10) continue;
                ++cells;
                chiSquare += (chosen[i] - said[i]) * (chosen[i] - said[i]) / said[i];
            }
            EXPECT_NEAR(chiSquare, cells, 5 * std::sqrt(2.0 * cells)) << width << " x " << height;
            const size_t last = static_cast<size_t>(columns / 2) * std::max(rows / 2, 1);
            glm::dvec4 total(0);
            for (size_t i = tree->nodes.size() - last; i < tree->nodes.size(); ++i)
                total += glm::dvec4(tree->nodes[i]);
            EXPECT_NEAR(total.x + total.y + total.z + total.w, 1, 1e-6);
        }
    }
}

TEST(SkyMap, NoLightIsOutOfTheTreesReach) {
    // Where a bilinear filter shows light, a cell must have a chance; and its density must be near
    // to the light's share of the power.
    const ImageRgba32f picture = [] {
        ImageRgba32f p = constantPicture(64, 32, 0);
        paint(p, 0, 9, 100);
        return p;
    }();
    const SkyMap map = makeSkyMap(picture);
    ASSERT_EQ(map.whole.levels, 6);
    EXPECT_GT(map.brightShare, 0.9f);
    const auto probability = [&](int x, int y) {
        const size_t nodesAbove = 1 + 2 + 8 + 32 + 128;
        const glm::vec4 node =
            map.whole
                .nodes[nodesAbove + static_cast<size_t>(y / 2) * 32 + static_cast<size_t>(x / 2)];
        return static_cast<double>(node[2 * (y % 2) + x % 2]) / solidAngle(y, 32);
    };
    const double middle = probability(0, 9);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const int dx = std::min(x, 64 - x), dy = std::abs(y - 9);
            const double share = (dx == 0   ? 0.75
                                  : dx == 1 ? 0.125
                                            : 0) *
                                 (dy == 0   ? 0.75
                                  : dy == 1 ? 0.125
                                            : 0) /
                                 (0.75 * 0.75);
            EXPECT_NEAR(probability(x, y) / middle, share, 1e-5) << x << ", " << y;
        }
}

TEST(SkyMap, LevelsKeepThePowerAndTheSplitAddsUp) {
    const ImageRgba32f picture = spottedPicture(50, 27, 4);
    const SkyMap map = makeSkyMap(picture);
    double power = 0;
    for (int y = 0; y < 27; ++y)
        for (int x = 0; x < 50; ++x)
            power += picture.at(x, y)[1] * solidAngle(y, 27) * 27 * 2 / 50 / (4 * kPi);
    EXPECT_NEAR(map.mean.y, power, 1e-4 * power);
    int width = 50, height = 27;
    for (const SkyLevel& level : map.levels) {
        EXPECT_EQ(level.width, width);
        EXPECT_EQ(level.height, height);
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        double whole = 0, dim = 0;
        for (int y = 0; y < level.height; ++y)
            for (int x = 0; x < level.width; ++x) {
                const size_t i = (static_cast<size_t>(y) * level.width + x) * 4;
                const double angle =
                    solidAngle(y, level.height) * level.height * 2 / level.width / (4 * kPi);
                const double green = glm::unpackHalf1x16(level.texels[i + 1]) * map.scale;
                const double above = glm::unpackHalf1x16(level.texels[i + 3]) * map.scale;
                whole += (green + above) * angle;
                dim += green * angle;
            }
        EXPECT_NEAR(whole, power, 2e-3 * power) << level.width;
        EXPECT_NEAR(dim, power * (1 - map.brightShare), 4e-3 * power) << level.width;
    }
    EXPECT_EQ(map.levels.back().width, 1);
}

TEST(SkyMap, EvenLightIsNoLamp) {
    const SkyMap map = makeSkyMap(constantPicture(16, 8, 3));
    EXPECT_EQ(map.brightShare, 0);
    EXPECT_EQ(map.bright.levels, 0);
    EXPECT_EQ(map.levels[0].texels[3], 0) << "all of it is ambient";
    EXPECT_EQ(makeSkyMap(constantPicture(4, 2, 0)).brightShare, 0) << "and neither is none";
}

TEST(SkyMap, MendsWhatIsNoLight) {
    ImageRgba32f picture = constantPicture(8, 4, 1);
    picture.at(0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
    picture.at(1, 0)[1] = std::numeric_limits<float>::infinity();
    picture.at(2, 0)[2] = -5;
    paint(picture, 3, 2, 1e30f);
    const SkyMap map = makeSkyMap(picture);
    EXPECT_EQ(map.mendedTexels, 4u);
    for (const SkyLevel& level : map.levels)
        for (const uint16_t half : level.texels) {
            const float v = glm::unpackHalf1x16(half);
            EXPECT_TRUE(std::isfinite(v) && v >= 0) << v;
        }
    for (const glm::vec4& node : map.whole.nodes) EXPECT_TRUE(std::isfinite(node.x + node.w));
}

TEST(SkyMap, DirectionsAreThoseOfThreeJsAndCycles) {
    const auto expectDirection = [](float u, float v, const glm::vec3& d) {
        EXPECT_LT(glm::length(skyDirection(u, v) - d), 1e-6f) << u << ", " << v;
    };
    expectDirection(0.5f, 0.5f, {1, 0, 0});
    expectDirection(0.75f, 0.5f, {0, 0, 1});
    expectDirection(0.25f, 0.5f, {0, 0, -1});
    expectDirection(0.0f, 0.5f, {-1, 0, 0});
    expectDirection(0.3f, 0.0f, {0, 1, 0});
}

TEST(Atmosphere, SunOverheadIsDimmedAsOnPaper) {
    // Optical depth of clean air: density times scale height, and a tent of ozone 15 km to each
    // side.
    const Atmosphere air = makeAtmosphere({90, 1, glm::vec3(0.2f)});
    EXPECT_LT(air.adaptation, 1.1f);
    const glm::dvec3 depth = glm::dvec3(5.802e-3, 13.558e-3, 33.1e-3) * 8.0 +
                             glm::dvec3(0.650e-3, 1.881e-3, 0.085e-3) * 15.0;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(air.sunIrradiance[c] / air.adaptation, kSunIrradiance * std::exp(-depth[c]),
                    0.01)
            << c;
}

glm::vec3 pixelOf(const Atmosphere& air, int x, int y) {
    const auto p = air.sky.at(x, y);
    return {p[0], p[1], p[2]};
}

TEST(Atmosphere, IsBlueAboveAndRedAtDuskAndMakesNoLight) {
    float before = 1e9f;
    for (const float elevation : {60.0f, 30.0f, 10.0f, 2.0f, -3.0f, -9.0f}) {
        const Atmosphere air = makeAtmosphere({elevation, 2.5f, glm::vec3(0.2f)});
        const glm::vec3 zenith = pixelOf(air, 10, 2);
        EXPECT_GT(zenith.z, 1.2f * zenith.x) << elevation;
        float light = 0;
        for (int y = 0; y < air.sky.height / 2; ++y)
            for (int x = 0; x < air.sky.width; ++x) {
                const float up = kPi * (0.5f - (static_cast<float>(y) + 0.5f) / 256);
                light += luminance(pixelOf(air, x, y)) * std::cos(up) * std::sin(up) * (kPi / 256) *
                         (2 * kPi / 512);
            }
        const float sine = std::sin(glm::radians(std::max(elevation, 0.0f)));
        const float arrives = (light + luminance(air.sunIrradiance) * sine) / air.adaptation;
        EXPECT_LT(arrives, before) << "the day ends";
        if (elevation > 5) {
            EXPECT_LT(arrives, kSunIrradiance * sine) << "light out of nothing";
        }
        before = arrives;
        const glm::vec3 low = pixelOf(air, 256, 125);
        if (elevation < 5) {
            EXPECT_GT(low.x, 1.5f * low.z) << elevation;
        }
    }
}

}  // namespace
}  // namespace vitrine
