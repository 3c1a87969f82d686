// SPDX-License-Identifier: MIT
// The functions of shaders/lib/material in double precision against other descriptions of the same:
// a pattern that a function filters is sampled here a hundred thousand times a pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sdf/library_in_cpp.hpp"

namespace vitrine {

namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

constexpr double kTau = 6.283185307179586;

std::mt19937 generator{20261122};

double random(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
}
dvec3 randomPoint(double reach) {
    const double x = random(-reach, reach), y = random(-reach, reach), z = random(-reach, reach);
    return {x, y, z};
}
dvec3 randomUnit() {
    dvec3 p(0);
    while (glm::length(p) < 0.1 || glm::length(p) > 1) p = randomPoint(1);
    return glm::normalize(p);
}

/// Mean of f over a box around p, by points in the middles of a grid.
template <class F>
double sampledMean(const F& f, const dvec2& p, const dvec2& width, int nx, int ny) {
    double sum = 0;
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j)
            sum += f(p + width * dvec2((i + 0.5) / nx - 0.5, (j + 0.5) / ny - 0.5));
    return sum / (nx * ny);
}

bool isOdd(double x) {
    return std::fmod(std::abs(std::floor(x)), 2) == 1;
}

/// A wall as a mason lays it: is there a brick here? Searches all bricks near by.
bool brickHere(const dvec2& p, const dvec2& size, double joint) {
    const int nearRow = static_cast<int>(p.y / size.y), nearColumn = static_cast<int>(p.x / size.x);
    for (int row = nearRow - 3; row <= nearRow + 3; ++row)
        for (int column = nearColumn - 3; column <= nearColumn + 3; ++column) {
            const dvec2 low((column - (row % 2 != 0 ? 0.5 : 0.0)) * size.x, row * size.y);
            const dvec2 inside = p - low;
            if (inside.x > joint / 2 && inside.x < size.x - joint / 2 && inside.y > joint / 2 &&
                inside.y < size.y - joint / 2)
                return true;
        }
    return false;
}

}  // namespace

TEST(Patterns, ASquareWaveAndStripesAreTheirMeans) {
    for (int i = 0; i < 400; ++i) {
        const dvec2 p(random(-6, 6), 0);
        const double width = i % 3 == 0 ? random(0.002, 0.1) : random(0.1, 4);
        const double share = random(0.05, 0.95);
        const auto wave = [](const dvec2& q) { return isOdd(q.x) ? -1.0 : 1.0; };
        const auto stripe = [&](const dvec2& q) {
            return q.x - std::floor(q.x) < share ? 1.0 : 0.0;
        };
        EXPECT_NEAR(library::patWave(p.x, width), sampledMean(wave, p, dvec2(width), 4000, 1), 4e-3)
            << p.x << ", " << width;
        EXPECT_NEAR(library::patStripes(p.x, share, width),
                    sampledMean(stripe, p, dvec2(width), 4000, 1), 4e-3)
            << p.x << ", " << width << ", " << share;
    }
}

TEST(Patterns, TheCheckerIsTheIntegralOfTheChecker) {
    for (int i = 0; i < 120; ++i) {
        const dvec2 p(random(-5, 5), random(-5, 5)), width(random(0.01, 3), random(0.01, 3));
        const auto board = [](const dvec2& q) { return isOdd(q.x) == isOdd(q.y) ? 1.0 : 0.0; };
        EXPECT_NEAR(library::patChecker(p, width), sampledMean(board, p, width, 400, 400), 6e-3)
            << p.x << ", " << p.y << " / " << width.x << ", " << width.y;
        const auto tile = [](const dvec2& q) {
            const dvec2 off = glm::abs(q - glm::round(q));
            return std::min(off.x, off.y) < 0.05 ? 1.0 : 0.0;
        };
        EXPECT_NEAR(library::patTiles(p, 0.1, width), sampledMean(tile, p, width, 400, 400), 6e-3);
    }
}

TEST(Patterns, FarAwayTheCheckerIsGrey) {
    for (const double width : {2.0, 4.0, 100.0})
        for (int i = 0; i < 50; ++i) {
            const dvec2 p(random(-50, 50), random(-50, 50));
            EXPECT_NEAR(library::patChecker(p, dvec2(width)), 0.5, 1e-9) << "whole periods";
            // A wave leaves at most half a period: 1 / width of it.
            EXPECT_NEAR(library::patChecker(p, dvec2(width + 0.7)), 0.5, 0.5 / (width * width));
        }
    EXPECT_NEAR(library::patChecker({0.5, 0.5}, dvec2(0)), 1, 1e-9);
    EXPECT_NEAR(library::patChecker({1.5, 0.5}, dvec2(0)), 0, 1e-9);
    EXPECT_NEAR(library::patChecker({-0.5, 0.5}, dvec2(0)), 0, 1e-9);
}

TEST(Patterns, BricksLieAsAMasonLaysThem) {
    const dvec2 size(0.5, 0.2);
    constexpr double kJoint = 0.03;
    for (int i = 0; i < 4000; ++i) {
        const dvec2 p(random(-2, 2), random(-2, 2));
        const dvec4 brick = library::patBricks(p, size, kJoint, dvec2(1e-9));
        if (brick.x > 0.01 && brick.x < 0.99) continue;  // on an edge
        EXPECT_EQ(brick.x < 0.5, brickHere(p, size, kJoint)) << p.x << ", " << p.y;
        if (brick.x > 0.5) {
            EXPECT_LT(brick.w, 0.01) << "no height in the mortar";
        }
        // In the middle of its brick there is that brick, too, in full height.
        const dvec2 middle((brick.y + (isOdd(brick.z) ? 0.0 : 0.5)) * size.x,
                           (brick.z + 0.5) * size.y);
        const dvec4 there = library::patBricks(middle, size, kJoint, dvec2(1e-9));
        EXPECT_EQ(dvec3(there.y, there.z, there.w), dvec3(brick.y, brick.z, 1));
        EXPECT_LE(std::abs(p.x - middle.x), size.x / 2 + 1e-9);
        EXPECT_LE(std::abs(p.y - middle.y), size.y / 2 + 1e-9);
    }
}

TEST(Patterns, BricksAreFiltered) {
    const dvec2 size(0.5, 0.2);
    constexpr double kJoint = 0.03;
    const auto mortar = [&](const dvec2& q) { return brickHere(q, size, kJoint) ? 0.0 : 1.0; };
    for (int i = 0; i < 60; ++i) {
        const dvec2 p(random(-2, 2), random(-2, 2));
        // Within a course exact.
        const dvec2 flat(random(0.05, 2), 1e-3);
        if (std::abs(p.y / size.y - std::round(p.y / size.y)) > 0.01) {
            EXPECT_NEAR(library::patBricks(p, size, kJoint, flat).x,
                        sampledMean(mortar, p, flat, 800, 2), 0.01);
        }
        // A few courses high: the mean of the upright joints stands for them.
        const dvec2 high(random(0.05, 2), random(0.4, 1));
        EXPECT_NEAR(library::patBricks(p, size, kJoint, high).x,
                    sampledMean(mortar, p, high, 100, 200), 0.06);
    }
    const double share = 1 - (1 - kJoint / size.x) * (1 - kJoint / size.y);
    EXPECT_NEAR(library::patBricks({0.3, 0.7}, size, kJoint, size * 8.0).x, share, 1e-9);
}

TEST(Patterns, DotsAreDiscsAndKeepTheirMean) {
    for (const double radius : {0.1, 0.3, 0.5}) {
        for (int i = 0; i < 500; ++i) {
            const dvec2 p(random(-3, 3), random(-3, 3));
            const dvec2 off = p - glm::floor(p) - 0.5;
            const double rim = glm::length(off) - radius;
            if (std::abs(rim) > 0.01) {
                EXPECT_EQ(library::patDots(p, radius, dvec2(0.01)), rim < 0 ? 1 : 0);
            }
        }
        for (const double width : {0.01, 0.1, 0.2, 1.5, 20.0}) {
            if (width < 1 && (width > radius || radius + width / 2 > 0.5))
                continue;  // all of the disc is rim, or rims meet
            const auto dots = [&](const dvec2& q) {
                return library::patDots(q, radius, dvec2(width));
            };
            EXPECT_NEAR(sampledMean(dots, {0.3, 0.2}, dvec2(1), 200, 200),
                        kTau / 2 * radius * radius, 0.012)
                << radius << ", " << width;
        }
    }
}

TEST(Mappings, RoundOnesCanBeUndone) {
    for (int i = 0; i < 500; ++i) {
        const dvec3 p = random(0.2, 3) * randomUnit();
        const dvec2 uv = library::uvSphere(p), side = library::uvCylinder(p);
        ASSERT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
        const double around = kTau * uv.x, up = kTau / 2 * (uv.y - 0.5);
        const dvec3 again =
            dvec3(std::cos(around) * std::cos(up), std::sin(up), -std::sin(around) * std::cos(up)) *
            glm::length(p);
        EXPECT_LT(glm::length(again - p), 1e-8);
        EXPECT_EQ(side, dvec2(uv.x, p.y));
    }
}

TEST(Mappings, TheSeamIsASeamAndPolesAreFinite) {
    const dvec2 below = library::uvSphere({1, 0.2, -1e-9}),
                above = library::uvSphere({1, 0.2, 1e-9});
    EXPECT_NEAR(below.x, 0, 1e-6);
    EXPECT_NEAR(above.x, 1, 1e-6);
    EXPECT_NEAR(below.y, above.y, 1e-9);
    EXPECT_NEAR(library::uvCylinder({1, 0.2, 1e-9}).x, 1, 1e-6);
    // Patterns that repeat a whole number of times do not show it.
    EXPECT_NEAR(library::patChecker(dvec2(12, 6) * below, dvec2(0.1)),
                library::patChecker(dvec2(12, 6) * above, dvec2(0.1)), 1e-5);
    EXPECT_NEAR(library::uvSphere({0, 1, 0}).y, 1, 1e-9);
    EXPECT_NEAR(library::uvSphere({0, -1, 0}).y, 0, 1e-9);
    for (const double x : {0.0, 1.0, -1.0})
        for (const double z : {0.0, 1.0, -1.0}) {
            const dvec2 uv = library::uvSphere({x, 0, z});
            EXPECT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
        }
}

TEST(Mappings, EverySideOfABoxIsTheRightWayRound) {
    for (int i = 0; i < 300; ++i) {
        const dvec3 n = randomUnit(), p = randomPoint(2);
        dvec3 u(0), v(0);  // which way they grow
        for (int axis = 0; axis < 3; ++axis) {
            dvec3 step(0);
            step[axis] = 1;
            const dvec2 grown = library::uvBox(p + step, n) - library::uvBox(p, n);
            u[axis] = grown.x;
            v[axis] = grown.y;
        }
        const dvec3 out = glm::cross(u, v), a = glm::abs(n);
        const double most = std::max({a.x, a.y, a.z});
        EXPECT_NEAR(glm::dot(out, n), most, 1e-9) << n.x << " " << n.y << " " << n.z;
        EXPECT_NEAR(glm::length(u), 1, 1e-9);
        if (most != a.y) {
            EXPECT_NEAR(v.y, 1, 1e-9) << "up is up";
        }
    }
}

TEST(Mappings, TriplanarSharesAddUp) {
    for (int i = 0; i < 300; ++i) {
        const dvec3 n = randomUnit();
        const double sharpness = random(1, 12);
        const dvec3 share = library::uvTriplanar(n, sharpness);
        EXPECT_NEAR(share.x + share.y + share.z, 1, 1e-12);
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                if (std::abs(n[a]) > 0.05 && std::abs(n[b]) > 0.05) {
                    const double ratio = std::pow(std::abs(n[a] / n[b]), sharpness);
                    if (ratio < 1e3 && ratio > 1e-3) {
                        EXPECT_NEAR(share[a] / share[b] / ratio, 1, 0.11);
                    }
                }
        const dvec3 same = library::uvTriplanar(-n, sharpness);
        EXPECT_EQ(same, share);
    }
    EXPECT_NEAR(library::uvTriplanar({0, -1, 0}, 4.0).y, 1, 1e-9);
    EXPECT_EQ(library::uvPlane({1, 2, 3}, 0), dvec2(3, 2));
    EXPECT_EQ(library::uvPlane({1, 2, 3}, 1), dvec2(1, 3));
    EXPECT_EQ(library::uvPlane({1, 2, 3}, 2), dvec2(1, 2));
}

TEST(Mappings, BumpsAreTheNormalsOfTheDisplacedSurface) {
    // On a plane: the normal of the graph y = h(x, z).
    for (int i = 0; i < 100; ++i) {
        const dvec3 g = randomPoint(2);
        const dvec3 graph = glm::normalize(dvec3(-g.x, 1, -g.z));
        EXPECT_LT(glm::length(library::uvBump({0, 1, 0}, g) - graph), 1e-9);
    }
    // On a ball r = 1 + h(direction): the cross product of two ways along that surface.
    const auto height = [](const dvec3& n) { return 0.05 * std::sin(5 * n.x) * std::cos(4 * n.z); };
    for (int i = 0; i < 100; ++i) {
        const dvec3 n = randomUnit();
        const dvec3 a = glm::normalize(glm::cross(n, dvec3(0.3, 0.5, -0.8))), b = glm::cross(n, a);
        const auto at = [&](double x, double y) {
            const dvec3 direction = glm::normalize(n + x * a + y * b);
            return (1 + height(direction)) * direction;
        };
        constexpr double kStep = 1e-5;
        const dvec3 truth =
            glm::normalize(glm::cross(at(kStep, 0) - at(-kStep, 0), at(0, kStep) - at(0, -kStep)));
        const double radius = 1 + height(n);
        const auto slope = [&](const dvec3& way) {
            return (height(glm::normalize(n + kStep * way)) -
                    height(glm::normalize(n - kStep * way))) /
                   (2 * kStep) / radius;
        };
        const dvec3 bent = library::uvBump(n, slope(a) * a + slope(b) * b + random(-1, 1) * n);
        EXPECT_LT(glm::length(bent - truth), 1e-5);
    }
}

TEST(Patterns, NoiseLosesItsOctavesWithThePixel) {
    double before = 1e9;
    for (const double width : {0.0, 0.05, 0.1, 0.2, 0.4, 0.8, 1.1}) {
        double variance = 0;
        for (int i = 0; i < 3000; ++i) {
            const dvec3 p = randomPoint(20);
            const double value = library::patNoise(p, 4, 0.6, width);
            variance += value * value;
            if (width <= 0.3 / 8) {
                ASSERT_NEAR(value, library::noiseFbm(p, 4, 0.6), 1e-12) << "all of it near by";
            }
        }
        EXPECT_LE(variance, 1.1 * before) << width;
        before = variance;
    }
    EXPECT_EQ(before, 0);
}

TEST(Patterns, CellsKnowTheTwoNearestPoints) {
    for (int i = 0; i < 2000; ++i) {
        const dvec3 p = randomPoint(10);
        std::vector<std::pair<double, dvec3>> all;
        for (int x = -2; x <= 2; ++x)
            for (int y = -2; y <= 2; ++y)
                for (int z = -2; z <= 2; ++z) {
                    const dvec3 cell = glm::floor(p) + dvec3(x, y, z);
                    const dvec3 u = library::noiseHash(cell);
                    all.emplace_back(glm::length(cell + 0.3 + 0.4 * u - p), u);
                }
        std::sort(all.begin(), all.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        const dvec4 cell = library::patCells(p);
        ASSERT_NEAR(cell.x, all[0].first, 1e-9);
        ASSERT_NEAR(cell.x, library::noiseCellular(p), 1e-9);
        ASSERT_NEAR(cell.y, all[1].first, 1e-9) << p.x << " " << p.y << " " << p.z;
        ASSERT_EQ(dvec2(cell.z, cell.w), dvec2(all[0].second.x, all[0].second.y));
    }
}

TEST(Patterns, WoodAndMarbleHaveTheMeansThatTheyFadeTo) {
    double wood = 0, marble = 0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
        const dvec3 p = randomPoint(9);
        const double w = library::patWood(p, 3.0, 0.2, 0.0), m = library::patMarble(p, 1.0, 0.0);
        ASSERT_TRUE(w >= 0 && w <= 1 && m >= 0 && m <= 1);
        wood += w / kCount;
        marble += m / kCount;
        EXPECT_EQ(library::patWood(p, 3.0, 0.2, 2.0), 0.5);
        EXPECT_EQ(library::patMarble(p, 1.0, 2.0), 0.2);
    }
    EXPECT_NEAR(wood, 0.5, 0.01);
    EXPECT_NEAR(marble, 0.2, 0.01);
    // Without wobble, rings: the same all around and all along.
    EXPECT_NEAR(library::patWood({0.6, 1, 0}, 3.0, 0.0, 0.0),
                library::patWood({0.36, -2, 0.48}, 3.0, 0.0, 0.0), 1e-9);
    EXPECT_NEAR(library::patWood({0.5, 0, 0}, 1.0, 0.0, 0.0), 0.5 / 0.8, 1e-9);
}

TEST(Patterns, WearEndsWhereItSays) {
    constexpr double kRadius = 0.05;
    const dvec3 half(0.5, 0.4, 0.6);
    // The curvature that the march finds: the field on a cross in the plane of the surface.
    const auto wear = [&](double way, double amount) {
        const dvec3 p(half.x - way, half.y, 0.1);
        double sum = 0;
        for (const double side : {-kRadius, kRadius})
            sum += library::sdBox(p + dvec3(side, 0, 0), half) +
                   library::sdBox(p + dvec3(0, 0, side), half);
        return library::patWorn(sum / (2 * kRadius * kRadius), kRadius, amount, 0.0);
    };
    for (const double amount : {0.3, 0.5, 0.8}) {
        EXPECT_EQ(wear(0.0, amount), 1);
        EXPECT_NEAR(wear(amount * kRadius, amount), 0.5, 1e-6);
        EXPECT_EQ(wear((amount + 0.13) * kRadius, amount), 0);
        EXPECT_EQ(wear(0.3, amount), 0);
    }
    EXPECT_EQ(library::patWorn(-30.0, kRadius, 0.5, 0.0), 0) << "a groove is not worn";
}

TEST(Patterns, EveryExampleHasAColourEverywhere) {
    EXPECT_GT(library::kPatterns.size(), 15u);
    for (const Pattern& pattern : library::kPatterns)
        for (int i = 0; i < 200; ++i) {
            const dvec3 p = i < 27 ? dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1) : randomPoint(1.2);
            const dvec3 c =
                pattern.color({p, randomUnit(), dvec3(random(0.001, 0.05)), random(-20, 20), 0.05});
            for (int k = 0; k < 3; ++k)
                ASSERT_TRUE(c[k] > -0.01 && c[k] < 1.01) << pattern.text << ": " << c[k];
        }
}

}  // namespace vitrine
