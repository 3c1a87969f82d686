// SPDX-License-Identifier: MIT
// The shapes of shaders/lib/sdf enclose what they should. Distances follow from the surface
// (library_claims_test.cpp), so this pins them down.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "sdf/library.hpp"
#include "sdf/library_in_cpp.hpp"
#include "sdf/library_memberships.hpp"

namespace vitrine {
namespace {

using glm::dvec3;

constexpr double kPi2 = 6.283185307179586;

/// Membership is known here: sheets and wires, whose thickness is a bound, are tested below.
bool isSheet(const std::string& name) {
    for (const char* sheet : {"sdGyroid", "sdSchwarzP", "sdSchwarzD", "sdNeovius", "sdSchoenIwp",
                              "sdHelix", "sdSpring"})
        if (name == sheet) return true;
    return false;
}

/// How finely the brute-force memberships know their surface.
double slack(const std::string& name) {
    for (const char* coarse : {"sdTriangle", "sdQuad", "sdRhombus"})
        if (name == coarse) return 0.004;
    return 2e-4;
}

}  // namespace

TEST(LibraryShapes, EncloseWhatTheyShould) {
    const std::map<std::string, Inside> inside = memberships();
    std::map<std::string, int> seen;
    for (const Example& example : library::kExamples) {
        const std::string& name = example.function;
        if (name.compare(0, 2, "sd") != 0 || seen[name]++ > 0 || isSheet(name)) continue;
        if (sdfLibrary().find(name)->quality == LibraryFunction::Quality::kNone) continue;
        const auto membership = inside.find(name);
        if (membership == inside.end()) {
            ADD_FAILURE() << "nothing says what " << name << " encloses";
            continue;
        }
        std::mt19937 random(11);
        std::uniform_real_distribution<double> range(-1.3, 1.3);
        const bool flat = name.compare(0, 3, "sd2") == 0;
        int wrong = 0, within = 0;
        for (int i = 0; i < 3000; ++i) {
            const double x = range(random), y = range(random), z = range(random);
            const dvec3 p(x, y, flat ? 0 : z);
            const double d = example.value(p);
            if (std::abs(d) < slack(name)) continue;
            const bool in = membership->second(p);
            within += in ? 1 : 0;
            if (in != (d < 0) && ++wrong <= 2)
                ADD_FAILURE() << example.text << " is " << d << " at " << p.x << ", " << p.y << ", "
                              << p.z;
        }
        EXPECT_EQ(wrong, 0) << name;
        EXPECT_GT(within, 10) << name << ": too few points inside to tell";
    }
}

TEST(LibraryShapes, SheetsFollowTheirEquation) {
    namespace lib = library;
    std::mt19937 random(12);
    std::uniform_real_distribution<double> range(-1.3, 1.3);
    const double k = kPi2 / 0.8;
    for (int i = 0; i < 3000; ++i) {
        const dvec3 p(range(random), range(random), range(random));
        const dvec3 q = k * p, s = glm::sin(q), c = glm::cos(q);
        const double thick = 0.03;
        const auto same = [&](double d, double equation, double slope) {
            ASSERT_EQ(d < 0, std::abs(equation) < thick * k * slope);
        };
        same(lib::sdGyroid(p, 0.8, thick), s.x * c.y + s.y * c.z + s.z * c.x, std::sqrt(3));
        same(lib::sdSchwarzP(p, 0.8, thick), c.x + c.y + c.z, std::sqrt(3));
        same(lib::sdSchwarzD(p, 0.8, thick),
             s.x * s.y * s.z + s.x * c.y * c.z + c.x * s.y * c.z + c.x * c.y * s.z, std::sqrt(3));
        same(lib::sdNeovius(p, 0.8, thick), 3 * (c.x + c.y + c.z) + 4 * c.x * c.y * c.z, 7);
        same(lib::sdSchoenIwp(p, 0.8, thick),
             2 * (c.x * c.y + c.y * c.z + c.z * c.x) -
                 (std::cos(2 * q.x) + std::cos(2 * q.y) + std::cos(2 * q.z)),
             5.2);
    }
}

TEST(LibraryShapes, AHelixNeverPromisesMoreThanTheDistanceToItsWire) {
    namespace lib = library;
    std::mt19937 random(13);
    std::uniform_real_distribution<double> range(-1.3, 1.3);
    for (const double rise : {0.5, 1.1}) {
        const double coil = 0.5;
        double least = 1e9;
        for (int i = 0; i < 600; ++i) {
            const dvec3 p(range(random), range(random), range(random));
            double truth = 1e9;
            for (double turn = -4; turn < 4; turn += 0.0005) {
                const double a = kPi2 * turn;
                const dvec3 q(coil * std::cos(a), rise * turn, coil * std::sin(a));
                truth = std::min(truth, glm::length(p - q));
            }
            const double claimed = lib::sdHelix(p, coil, rise, 0);
            ASSERT_LE(claimed, truth + 1e-5) << p.x << " " << p.y << " " << p.z;
            if (truth > 0.01) least = std::min(least, claimed / truth);
        }
        EXPECT_GT(least, 0.3) << "or a ray would crawl";
    }
}

}  // namespace vitrine
