// SPDX-License-Identifier: MIT
// Operators and domains against what they mean, spelt out.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sdf/library_in_cpp.hpp"

namespace vitrine {

namespace {

using glm::dvec3;
namespace lib = library;

class Random {
  public:
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    dvec3 point(double reach) {
        const double x = (*this)(-reach, reach), y = (*this)(-reach, reach);
        return {x, y, (*this)(-reach, reach)};
    }

  private:
    std::mt19937 engine_{7};
};

/// A shape with no symmetry, within 0.35 of the origin along each axis.
double crooked(const dvec3& p) {
    return std::min(lib::sdSphere(p - dvec3(0.2, 0.15, 0.1), 0.14),
                    lib::sdCapsule(p, dvec3(-0.25, 0.2, 0), dvec3(0.1, -0.25, 0.2), 0.08));
}

struct Blend {
    const char* name;
    double (*call)(double, double, double);
    double thickness;  // of the seam, in widths, as its comment says
};

constexpr Blend kUnions[] = {
    {"opSmoothUnion", lib::opSmoothUnion, 0.25},
    {"opSmoothUnionCubic", lib::opSmoothUnionCubic, 1.0 / 6},
    {"opSmoothUnionCircular", lib::opSmoothUnionCircular, 0.3},
    {"opSmoothUnionExponential", lib::opSmoothUnionExponential, 0.6932},
};

}  // namespace

TEST(LibraryOperators, SmoothUnionsAreCommutativeAndOnlyAdd) {
    Random random;
    for (const Blend& blend : kUnions) {
        double thickest = 0;
        for (int i = 0; i < 3000; ++i) {
            const double a = random(-1, 1), b = i % 10 == 0 ? a : random(-1, 1);
            const double k = random(0.01, 0.8);
            const double d = blend.call(a, b, k);
            ASSERT_EQ(d, blend.call(b, a, k)) << blend.name;
            ASSERT_LE(d, std::min(a, b) + 1e-12) << blend.name;
            thickest = std::max(thickest, (std::min(a, b) - d) / k);
            if (std::abs(a - b) >= k && blend.call != lib::opSmoothUnionExponential) {
                ASSERT_NEAR(d, std::min(a, b), 1e-12) << blend.name << " changes beyond its width";
            }
        }
        EXPECT_LE(thickest, blend.thickness + 1e-9) << blend.name;
        EXPECT_GT(thickest, blend.thickness * 0.95) << blend.name;
    }
}

TEST(LibraryOperators, TheExponentialUnionIsAssociative) {
    Random random;
    const auto join = [](double a, double b) { return lib::opSmoothUnionExponential(a, b, 0.2); };
    for (int i = 0; i < 1000; ++i) {
        const double a = random(-1, 1), b = random(-1, 1), c = random(-1, 1);
        ASSERT_NEAR(join(join(a, b), c), join(a, join(b, c)), 1e-12);
    }
}

TEST(LibraryOperators, SeamsAreSmooth) {
    // The slope along a - b has no step: two neighbouring differences differ little.
    for (const Blend& blend : kUnions) {
        constexpr double kStep = 1e-4;
        for (double x = -1; x < 1; x += 0.01) {
            const auto at = [&](double t) { return blend.call(t, -t, 0.5); };
            const double left = (at(x) - at(x - kStep)) / kStep;
            const double right = (at(x + kStep) - at(x)) / kStep;
            ASSERT_NEAR(left, right, 20 * kStep) << blend.name << " at " << x;
        }
    }
}

TEST(LibraryOperators, FamiliesAreOneAnotherTurnedInsideOut) {
    using Three = double (*)(double, double, double);
    const Three families[][3] = {
        {lib::opSmoothUnion, lib::opSmoothIntersection, lib::opSmoothDifference},
        {lib::opRoundUnion, lib::opRoundIntersection, lib::opRoundDifference},
        {lib::opChamferUnion, lib::opChamferIntersection, lib::opChamferDifference},
        {[](double a, double b, double k) { return lib::opStairsUnion(a, b, k, 3); },
         [](double a, double b, double k) { return lib::opStairsIntersection(a, b, k, 3); },
         [](double a, double b, double k) { return lib::opStairsDifference(a, b, k, 3); }},
        {[](double a, double b, double k) { return lib::opColumnsUnion(a, b, k, 3); },
         [](double a, double b, double k) { return lib::opColumnsIntersection(a, b, k, 3); },
         [](double a, double b, double k) { return lib::opColumnsDifference(a, b, k, 3); }},
    };
    Random random;
    for (const auto& [join, common, without] : families)
        for (int i = 0; i < 1000; ++i) {
            const double a = random(-1, 1), b = random(-1, 1), k = random(0.1, 0.6);
            ASSERT_NEAR(join(a, b, k), join(b, a, k), 1e-12);
            ASSERT_NEAR(common(a, b, k), -join(-a, -b, k), 1e-12);
            ASSERT_NEAR(without(a, b, k), common(a, -b, k), 1e-12);
            ASSERT_LE(join(a, b, k), std::min(a, b) + 1e-12);
            ASSERT_GE(common(a, b, k), std::max(a, b) - 1e-12);
        }
}

TEST(LibraryOperators, SharesOfABlendAddUp) {
    EXPECT_EQ(lib::opSmoothUnionBlend(0.1, 0.1, 0.3).y, 0.5);
    EXPECT_EQ(lib::opSmoothUnionBlend(0.1, 0.5, 0.3).y, 0.0);
    EXPECT_EQ(lib::opSmoothUnionBlend(0.5, 0.1, 0.3).y, 1.0);
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const double a = random(-1, 1), b = random(-1, 1);
        const auto one = lib::opSmoothUnionBlend(a, b, 0.4),
                   two = lib::opSmoothUnionBlend(b, a, 0.4);
        ASSERT_NEAR(one.y + two.y, 1, 1e-12);
        // The share is the slope of the union by b.
        const double slope =
            (lib::opSmoothUnion(a, b + 1e-6, 0.4) - lib::opSmoothUnion(a, b - 1e-6, 0.4)) / 2e-6;
        ASSERT_NEAR(one.y, slope, 1e-5);
    }
}

TEST(LibraryOperators, StairsHaveTheirSteps) {
    // Along the line a + b = size + tread the outer corners, along a + b = size the inner ones.
    const double size = 0.8, count = 4, tread = size / count;
    for (int i = 0; i < 4; ++i) {
        const double a = size - i * tread, b = (i + 1) * tread;
        EXPECT_NEAR(lib::opStairsUnion(a, b, size, count), 0, 1e-9);
        EXPECT_GT(lib::opStairsUnion(a + 0.01, b + 0.01, size, count), 0);
        if (i > 0) {
            EXPECT_NEAR(lib::opStairsUnion(a, b - tread, size, count), 0, 1e-9);
        }
    }
    EXPECT_NEAR(lib::opStairsUnion(0.9, 0.0, size, count), 0, 1e-9) << "the plane beside them";
    EXPECT_GT(lib::opStairsUnion(0.85, 0.05, size, count), 0);
}

TEST(LibraryDomains, NeighboursMakeAnyRepetitionExact) {
    Random random;
    const dvec3 spacing(0.8, 0.9, 0.7);
    int plainIsWrong = 0;
    for (int i = 0; i < 3000; ++i) {
        dvec3 p = random.point(1.6);
        // Half of them at the walls between cells.
        if (i % 2 == 0) p.x = spacing.x * (std::round(p.x / spacing.x) + 0.5) + random(-1e-3, 1e-3);
        double found = 1e9, truth = 1e9;
        for (int n = 0; n < 8; ++n)
            found = std::min(found, crooked(lib::domRepeatNeighbour(p, spacing, n)));
        for (int x = -4; x <= 4; ++x)
            for (int y = -4; y <= 4; ++y)
                for (int z = -4; z <= 4; ++z)
                    truth = std::min(truth, crooked(p - spacing * dvec3(x, y, z)));
        ASSERT_NEAR(found, truth, 1e-12);
        plainIsWrong += crooked(lib::domRepeat(p, spacing)) > truth + 1e-6 ? 1 : 0;
        // The cheap way never goes farther than a hundredth of a cell too far.
        const double guarded =
            std::min(crooked(lib::domRepeat(p, spacing)), lib::domCellWall(p, spacing) + 0.007);
        ASSERT_LE(guarded, truth + 0.007);
    }
    EXPECT_GT(plainIsWrong, 100) << "as the comment warns";
}

TEST(LibraryDomains, PlainRepetitionIsExactForSymmetricShapes) {
    Random random;
    const dvec3 spacing(0.8);
    const auto shape = [](const dvec3& p) { return lib::sdBox(p, dvec3(0.3, 0.2, 0.35)); };
    for (int i = 0; i < 3000; ++i) {
        const dvec3 p = random.point(1.5);
        double truth = 1e9, limited = 1e9;
        for (int x = -4; x <= 4; ++x)
            for (int y = -4; y <= 4; ++y)
                for (int z = -4; z <= 4; ++z) {
                    const double d = shape(p - spacing * dvec3(x, y, z));
                    truth = std::min(truth, d);
                    if (x >= -1 && x <= 1 && y >= 0 && y <= 1 && z == 0)
                        limited = std::min(limited, d);
                }
        ASSERT_NEAR(shape(lib::domRepeat(p, spacing)), truth, 1e-12);
        ASSERT_NEAR(shape(lib::domRepeatLimited(p, spacing, dvec3(-1, 0, 0), dvec3(1, 1, 0))),
                    limited, 1e-12);
        ASSERT_EQ(lib::domRepeat(p, spacing), p - spacing * lib::domRepeatCell(p, spacing));
    }
}

TEST(LibraryDomains, MirroredRepetitionIsExactForAnyShape) {
    Random random;
    const dvec3 spacing(0.8);
    for (int i = 0; i < 3000; ++i) {
        const dvec3 p = random.point(1.5);
        double truth = 1e9;
        for (int x = -3; x <= 3; ++x)
            for (int y = -3; y <= 3; ++y)
                for (int z = -3; z <= 3; ++z) {
                    dvec3 q = p - spacing * dvec3(x, y, z);
                    // The cell at the origin is as it is, its neighbours are mirrored.
                    if (x % 2 != 0) q.x = -q.x;
                    if (y % 2 != 0) q.y = -q.y;
                    if (z % 2 != 0) q.z = -q.z;
                    truth = std::min(truth, crooked(q));
                }
        ASSERT_NEAR(crooked(lib::domRepeatMirrored(p, spacing)), truth, 1e-12) << p.x << " " << p.y;
    }
}

TEST(LibraryDomains, PolarRepetition) {
    Random random;
    // Within the first of five sectors, and no mirror image of itself.
    const auto shape = [](const dvec3& p) { return crooked(p - dvec3(0.9, 0, 0.05)); };
    for (int i = 0; i < 3000; ++i) {
        const dvec3 p = random.point(1.5);
        double truth = 1e9, mirrored = 1e9;
        for (int n = 0; n < 5; ++n) {
            const double turn = 2 * 3.14159265358979 * n / 5;
            // The copy at the angle `turn` from +x towards +z.
            const dvec3 q(std::cos(turn) * p.x + std::sin(turn) * p.z, p.y,
                          std::cos(turn) * p.z - std::sin(turn) * p.x);
            truth = std::min(truth, shape(q));
            mirrored = std::min(mirrored, std::min(shape(q), shape(dvec3(q.x, q.y, -q.z))));
        }
        double found = 1e9;
        for (int n = 0; n < 2; ++n)
            found = std::min(found, shape(lib::domRepeatPolarNeighbour(p, 5, n)));
        ASSERT_NEAR(found, truth, 1e-6);
        // Mirrored: exact for the half that lies on the positive side.
        const auto half = [](const dvec3& q) {
            return lib::sdSphere(q - dvec3(0.8, 0.1, 0.25), 0.2);
        };
        const double folded = half(lib::domRepeatPolarMirrored(p, 5));
        double copies = 1e9;
        for (int n = 0; n < 5; ++n) {
            const double turn = 2 * 3.14159265358979 * n / 5;
            const dvec3 q(std::cos(turn) * p.x + std::sin(turn) * p.z, p.y,
                          std::cos(turn) * p.z - std::sin(turn) * p.x);
            copies = std::min(copies, std::min(half(q), half(dvec3(q.x, q.y, -q.z))));
        }
        ASSERT_NEAR(folded, copies, 1e-6);
    }
}

TEST(LibraryDomains, TurnsAreRightHanded) {
    const double quarter = 1.5707963267948966;
    const auto near = [](const dvec3& a, const dvec3& b) { return glm::length(a - b) < 1e-12; };
    // The shape's point (1, 0, 0) is found where the turned shape has it.
    EXPECT_TRUE(near(lib::domRotateZ({0, 1, 0}, quarter), {1, 0, 0}));
    EXPECT_TRUE(near(lib::domRotateX({0, 0, 1}, quarter), {0, 1, 0}));
    EXPECT_TRUE(near(lib::domRotateY({1, 0, 0}, quarter), {0, 0, 1}));
    Random random;
    for (int i = 0; i < 100; ++i) {
        const dvec3 p = random.point(1);
        const double angle = random(-3, 3);
        ASSERT_TRUE(near(lib::domRotateAxis(p, {1, 0, 0}, angle), lib::domRotateX(p, angle)));
        ASSERT_TRUE(near(lib::domRotateAxis(p, {0, 1, 0}, angle), lib::domRotateY(p, angle)));
        ASSERT_TRUE(near(lib::domRotateAxis(p, {0, 0, 1}, angle), lib::domRotateZ(p, angle)));
    }
}

TEST(LibraryDomains, ABendKeepsTheLengthOfItsMiddle) {
    // A point of the arc of radius 2 about (0, 2, 0), a way of 0.7 from the origin along it.
    const dvec3 p(2 * std::sin(0.35), 2 - 2 * std::cos(0.35), 0.3);
    EXPECT_LT(glm::length(lib::domBend(p, 2) - dvec3(0.7, 0, 0.3)), 1e-12);
}

TEST(LibraryNoise, HasNoSeamsAndStaysInItsRange) {
    Random random;
    double value = 0, gradient = 0, simplex = 0, cells = 0;
    for (int i = 0; i < 40000; ++i) {
        const dvec3 p = random.point(40);
        value = std::max(value, std::abs(lib::noiseValue(p)));
        gradient = std::max(gradient, std::abs(lib::noiseGradient(p)));
        simplex = std::max(simplex, std::abs(lib::noiseSimplex(p)));
        cells = std::max(cells, lib::noiseCellular(p));
    }
    EXPECT_TRUE(value > 0.9 && value <= 1) << value;
    EXPECT_TRUE(gradient > 0.6 && gradient <= 0.87) << gradient;
    EXPECT_TRUE(simplex > 0.6 && simplex <= 1.05) << simplex;
    EXPECT_TRUE(cells > 0.9 && cells <= 1.22) << cells;
    for (int i = 0; i < 1000; ++i) {
        const dvec3 corner = glm::round(random.point(40));
        ASSERT_EQ(lib::noiseGradient(corner), 0);
        const dvec3 u = lib::noiseHash(corner);
        ASSERT_TRUE(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1 && u.z >= 0 && u.z < 1);
        ASSERT_NEAR(glm::length(lib::noiseDirection(corner)), 1, 1e-12);
    }
}

TEST(LibraryNoise, CellularKnowsTheNearestOfAllPoints) {
    Random random;
    for (int i = 0; i < 10000; ++i) {
        // At random, and near the corners of cells, where the cell across may have the nearest.
        dvec3 p = random.point(20);
        if (i % 2 == 0) p = glm::round(p) + random.point(0.2);
        const dvec3 cell = glm::floor(p);
        double truth = 1e9;
        for (int x = -2; x <= 2; ++x)
            for (int y = -2; y <= 2; ++y)
                for (int z = -2; z <= 2; ++z) {
                    const dvec3 other = cell + dvec3(x, y, z);
                    truth =
                        std::min(truth, glm::length(other + 0.3 + 0.4 * lib::noiseHash(other) - p));
                }
        ASSERT_NEAR(lib::noiseCellular(p), truth, 1e-12);
    }
}

namespace {

/// The largest slope that corner directions could give at p: sum of |w e + d (grad w . e)|.
template <class Corners>
double worstSlope(const dvec3& p, const dvec3& e, const Corners& corners) {
    double sum = 0;
    corners(p, [&](double weight, const dvec3& gradient, const dvec3& d) {
        sum += glm::length(weight * e + d * glm::dot(gradient, e));
    });
    return sum;
}

template <class Corners>
double searchSlope(const Corners& corners, double reach) {
    Random random;
    double best = 0;
    for (int start = 0; start < 40; ++start) {
        dvec3 p = random.point(reach), e = glm::normalize(random.point(1));
        double slope = worstSlope(p, e, corners);
        for (double step = 0.3; step > 1e-4; step *= 0.985) {
            const dvec3 q = p + random.point(step);
            const dvec3 f = glm::normalize(e + random.point(step));
            const double other = worstSlope(q, f, corners);
            if (other > slope) {
                slope = other;
                p = q;
                e = f;
            }
        }
        best = std::max(best, slope);
    }
    return best;
}

}  // namespace

TEST(LibraryNoise, TheSlopesClaimedAreTheLargestPossible) {
    const auto fade = [](double t) { return lib::noiseFade(t); };
    const auto slope = [](double t) { return 30 * t * t * (1 - t) * (1 - t); };
    const auto cube = [&](const dvec3& p, const auto& visit) {
        for (int i = 0; i < 8; ++i) {
            const dvec3 d = glm::fract(p) - dvec3(i & 1, (i >> 1) & 1, (i >> 2) & 1);
            const dvec3 near = 1.0 - glm::abs(d), sign = -glm::sign(d);
            const dvec3 w(fade(near.x), fade(near.y), fade(near.z));
            const dvec3 s = sign * dvec3(slope(near.x), slope(near.y), slope(near.z));
            visit(w.x * w.y * w.z, dvec3(s.x * w.y * w.z, w.x * s.y * w.z, w.x * w.y * s.z), d);
        }
    };
    const auto lattice = [](const dvec3& p, const auto& visit) {
        for (int i = -3; i <= 3; ++i)
            for (int j = -3; j <= 3; ++j)
                for (int k = -3; k <= 3; ++k) {
                    const dvec3 d = p - (dvec3(i, j, k) - (i + j + k) / 6.0);
                    const double near = std::max(0.5 - glm::dot(d, d), 0.0);
                    visit(70 * std::pow(near, 4), -560 * std::pow(near, 3) * d, d);
                }
    };
    const double gradient = searchSlope(cube, 0.5), simplex = searchSlope(lattice, 0.8);
    EXPECT_LE(gradient, 2.8);
    EXPECT_GT(gradient, 0.95 * 2.8) << "a bound that is far too large only costs steps";
    EXPECT_LE(simplex, 5.1);
    EXPECT_GT(simplex, 0.95 * 5.1);
}

}  // namespace vitrine
