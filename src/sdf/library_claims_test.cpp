// SPDX-License-Identifier: MIT
// What the comments of shaders/lib/sdf claim, measured on their examples in double precision.
//
// Slope: no point where the value changes faster than claimed, by random search, then uphill.
//
// Exactness, without knowing the shape: a field that nowhere changes faster than the way that is
// gone cannot be larger than the distance to its own zero set. If also the point reached by going
// its value down its slope lies on that set, it cannot be smaller. So both together mean: it is the
// distance to its zero set. That this is the right set is for library_shapes_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "sdf/library.hpp"
#include "sdf/library_in_cpp.hpp"

namespace vitrine {

namespace {

using glm::dvec3;
using Quality = LibraryFunction::Quality;

constexpr double kReach = 1.3;  // examples are shown and tested within this of the origin

class Sampler {
  public:
    explicit Sampler(const std::string& function)
        : flat_(function.compare(0, 3, "sd2") == 0), random_(20260801) {}

    dvec3 point(double reach) {
        std::uniform_real_distribution<double> range(-reach, reach);
        const double x = range(random_), y = range(random_), z = range(random_);
        return {x, y, flat_ ? 0 : z};
    }
    [[nodiscard]] dvec3 gradient(const Example& example, const dvec3& p) const {
        constexpr double kStep = 1e-6;
        dvec3 g(0);
        for (int i = 0; i < (flat_ ? 2 : 3); ++i) {
            dvec3 d(0);
            d[i] = kStep;
            g[i] = (example.value(p + d) - example.value(p - d)) / (2 * kStep);
        }
        return g;
    }

  private:
    bool flat_;
    std::mt19937 random_;
};

/// The slope that an example may have: a number, or 1 where it is divided by an expression. 0 if
/// nothing is claimed.
double claimedSlope(const LibraryFunction& f) {
    if (f.lipschitz.empty()) return f.quality == Quality::kExact ? 1 : 0;
    char* end = nullptr;
    const double number = std::strtod(f.lipschitz.c_str(), &end);
    return *end == '\0' ? number : 1;
}

const LibraryFunction& functionOf(const Example& example) {
    return *sdfLibrary().find(example.function);
}

/// The steepest place that can be found.
double steepest(const Example& example) {
    Sampler sampler(example.function);
    std::vector<std::pair<double, dvec3>> best;
    for (int i = 0; i < 4000; ++i) {
        const dvec3 p = sampler.point(kReach);
        best.emplace_back(glm::length(sampler.gradient(example, p)), p);
    }
    std::sort(best.begin(), best.end(), [](auto& a, auto& b) { return a.first > b.first; });
    best.resize(30);
    for (double reach = 0.1; reach > 1e-3; reach *= 0.9)
        for (auto& [slope, p] : best) {
            const dvec3 q = glm::clamp(p + sampler.point(reach), -kReach, kReach);
            const double other = glm::length(sampler.gradient(example, q));
            if (other > slope) {
                slope = other;
                p = q;
            }
        }
    return std::max_element(best.begin(), best.end(),
                            [](auto& a, auto& b) { return a.first < b.first; })
        ->first;
}

}  // namespace

TEST(LibraryClaims, NoFieldIsSteeperThanItSays) {
    int checked = 0;
    for (const Example& example : library::kExamples) {
        const double claimed = claimedSlope(functionOf(example));
        if (claimed == 0) continue;
        EXPECT_LE(steepest(example), claimed * 1.0001 + 1e-4) << example.text;
        ++checked;
    }
    EXPECT_GT(checked, 150);
}

TEST(LibraryClaims, NoFieldJumps) {
    for (const Example& example : library::kExamples) {
        const double claimed = claimedSlope(functionOf(example));
        if (claimed == 0) continue;
        Sampler sampler(example.function);
        double worst = 0;
        dvec3 where(0);
        for (int i = 0; i < 8000; ++i) {
            const dvec3 p = sampler.point(kReach);
            const dvec3 q = glm::clamp(p + sampler.point(i % 2 == 0 ? 0.3 : 0.02), -kReach, kReach);
            const double excess = std::abs(example.value(p) - example.value(q)) -
                                  claimed * glm::length(p - q) * 1.0001;
            if (excess > worst) {
                worst = excess;
                where = p;
            }
        }
        EXPECT_LE(worst, 2e-5) << example.text << " near " << where.x << " " << where.y << " "
                               << where.z;
    }
}

TEST(LibraryClaims, ExactOnesAreTheDistanceToTheirSurface) {
    int checked = 0;
    for (const Example& example : library::kExamples) {
        const Quality quality = functionOf(example).quality;
        if (quality == Quality::kNone || quality == Quality::kBound) continue;
        Sampler sampler(example.function);
        int samples = 0, notSteep = 0, offSurface = 0;
        double worst = 0;
        while (samples < 4000) {
            const dvec3 p = sampler.point(kReach);
            const double d = example.value(p);
            if (quality == Quality::kExactOutside && d < 0) continue;
            if (quality == Quality::kExactInside && d > 0) continue;
            ++samples;
            const dvec3 g = sampler.gradient(example, p);
            if (std::abs(glm::length(g) - 1) > 1e-3) {
                ++notSteep;  // on a crease, where two points of the surface are equally near
                continue;
            }
            const double left = std::abs(example.value(p - d * glm::normalize(g)));
            worst = std::max(worst, left);
            if (left > 2e-5) ++offSurface;
        }
        EXPECT_LE(notSteep, samples / 200) << example.text;
        EXPECT_LE(offSurface, 2) << example.text << ": worst " << worst;
        ++checked;
    }
    EXPECT_GT(checked, 80);
}

TEST(LibraryClaims, BoundsHoldTheShape) {
    int checked = 0;
    for (const Example& example : library::kExamples) {
        if (!example.bounds) continue;
        const Bounds bounds = example.bounds(dvec3(0));
        Sampler sampler(example.function);
        std::vector<dvec3> inside;
        for (int i = 0; i < 20000 && inside.size() < 300; ++i) {
            const dvec3 p = sampler.point(2 * kReach);
            if (example.value(p) < 0) inside.push_back(p);
        }
        ASSERT_FALSE(inside.empty()) << example.text;
        for (int face = 0; face < 6; ++face) {
            const int axis = face / 2;
            const double sign = face % 2 == 0 ? 1 : -1;
            // From the outermost of them, on outwards to the tip.
            dvec3 tip = *std::max_element(inside.begin(), inside.end(), [&](auto& a, auto& b) {
                return sign * a[axis] < sign * b[axis];
            });
            for (int i = 0; i < 3000; ++i) {
                const dvec3 q = tip + sampler.point(i % 3 == 0 ? 0.3 : i % 3 == 1 ? 0.05 : 0.005);
                if (example.value(q) < 0 && sign * q[axis] > sign * tip[axis]) tip = q;
            }
            const double limit = face % 2 == 0 ? bounds.high[axis] : bounds.low[axis];
            EXPECT_LE(sign * tip[axis], sign * limit + 1e-6)
                << example.text << " reaches out along " << sign << " times axis " << axis;
        }
        ++checked;
    }
    EXPECT_GT(checked, 50);
}

TEST(LibraryClaims, NoPlaceIsWithoutAValue) {
    // The middle, axes, planes and diagonals, where a division or a direction may fail.
    for (const Example& example : library::kExamples)
        for (int i = 0; i < 729; ++i) {
            const dvec3 p = dvec3(i % 9 - 4, (i / 9) % 9 - 4, i / 81 - 4) * 0.25;
            ASSERT_TRUE(std::isfinite(example.value(p)))
                << example.text << " at " << p.x << ", " << p.y << ", " << p.z;
        }
}

TEST(LibraryClaims, LoopsStayFarBelowTheBudget) {
    // pack/generate.cpp gives all loops of one call of a snippet 1024 iterations together.
    for (const Example& example : library::kExamples) {
        Sampler sampler(example.function);
        for (int i = 0; i < 100; ++i) {
            const int before = library::loops;
            (void)example.value(sampler.point(kReach));
            ASSERT_LE(library::loops - before, 256) << example.text;
        }
    }
}

}  // namespace vitrine
