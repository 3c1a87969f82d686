// SPDX-License-Identifier: MIT
// Fields whose slope is known on paper.
#include "sdf/field_slope.hpp"

#include <gtest/gtest.h>

#include "sdf/field_formula.hpp"

namespace vitrine {
namespace {

using test::answering;

FieldDomain domain(float half = 1, std::vector<Parameter> parameters = {}, bool moves = false) {
    Snippet snippet;
    snippet.parameters = std::move(parameters);
    snippet.usesTime = moves;
    return domainOf(snippet, {glm::vec3(-half), glm::vec3(half)}, {});
}

FieldReport measure(const FieldDomain& d, const test::Formula& formula) {
    return measureSlope(d, answering(formula));
}

TEST(FieldSlope, ADistanceIsClean) {
    for (const float half : {1e-3f, 1.0f, 500.0f}) {
        const FieldReport r = measure(domain(half), [&](const glm::vec3& p, float, const auto&) {
            return glm::length(p) - 0.5f * half;
        });
        EXPECT_NEAR(r.steepest.value, 1, 3e-3f) << half;
        EXPECT_EQ(r.lipschitz, 1) << half;
        EXPECT_EQ(r.steepShare, 0) << half;
        EXPECT_NEAR(r.negativeShare, 4 * kPi / 3 / 8 / 8, 2e-3) << "the sphere's share of the box";
        EXPECT_EQ(r.notFinite, 0u);
        EXPECT_EQ(r.jump, 0);
        EXPECT_FALSE(r.cut);
        EXPECT_TRUE(r.hasSurface() && !r.isSolid());
    }
}

TEST(FieldSlope, OfAnyConstant) {
    for (const float slope : {0.25f, 1.1f, 3.0f, 40.0f}) {
        const FieldReport r = measure(domain(), [&](const glm::vec3& p, float, const auto&) {
            return slope * (glm::length(p) - 0.5f);
        });
        EXPECT_NEAR(r.steepest.value, slope, 0.003f * slope);
        EXPECT_GE(r.lipschitz, slope);
        EXPECT_LE(r.lipschitz, std::max(1.1f * slope, 1.0f));
        EXPECT_EQ(r.jump, 0) << slope;
        EXPECT_EQ(r.steepShare, slope > 1 ? 1 : 0);
    }
}

// A slab of 1/500 of the box in which the slope is 3: an evenly spread sample meets it once in 500
// times, and only the finest steps fit into it.
TEST(FieldSlope, InANarrowCrease) {
    const FieldReport r = measure(domain(), [](const glm::vec3& p, float, const auto&) {
        return p.y + 2 * glm::clamp(p.y - 0.3127f, 0.0f, 0.004f);
    });
    EXPECT_NEAR(r.steepest.value, 3, 0.05f);
    EXPECT_NEAR(r.steepest.point.y, 0.3147f, 0.004f);
    EXPECT_EQ(r.jump, 0);
    EXPECT_LT(r.steepShare, 0.15);
}

TEST(FieldSlope, InASmallPlaceOnly) {
    // A ball of a radius of 1/20: 1/15,000 of the box. Only spread samples can find it; then the
    // climb finds its middle, where the slope is highest.
    const glm::vec3 spot(-0.41f, 0.37f, 0.63f);
    const FieldReport r = measure(domain(), [&](const glm::vec3& p, float, const auto&) {
        const float near = std::exp(-glm::dot(p - spot, p - spot) / (2 * 0.05f * 0.05f));
        return p.y + 0.1f * near;
    });
    // The largest slope of the bump is 0.1 / (0.05 sqrt(e)), below the spot, where it adds.
    EXPECT_NEAR(r.steepest.value, 1 + 0.1f / (0.05f * std::sqrt(std::exp(1.0f))), 0.06f);
    EXPECT_NEAR(r.steepest.point.y, spot.y - 0.05f, 0.02f);
}

TEST(FieldSlope, AtOneEndOfASlider) {
    const FieldReport r =
        measure(domain(1, {test::slider("a", 0, 0.1f, 1), test::slider("b", -2, 0, 2)}),
                [](const glm::vec3& p, float, const FieldSetting& s) {
                    return (1 + 2 * s[0].x * s[0].x) * (glm::length(p) - 0.5f);
                });
    EXPECT_NEAR(r.steepest.value, 3, 0.06f);
    EXPECT_GT(r.steepest.setting[0].x, 0.97f);
}

TEST(FieldSlope, ASettingInUseIsAsked) {
    // The range is only a guess here, as it is for a uniform without annotation.
    FieldDomain d = domain(1, {test::slider("a", 0, 0, 1)});
    d.settings.push_back({glm::vec4(7, 0, 0, 0)});
    const FieldReport r = measure(d, [](const glm::vec3& p, float, const FieldSetting& s) {
        return (1 + s[0].x) * (glm::length(p) - 0.5f);
    });
    EXPECT_NEAR(r.steepest.value, 8, 0.1f);
}

TEST(FieldSlope, AtALaterTimeOnly) {
    const auto formula = [](const glm::vec3& p, float time, const auto&) {
        const float late = glm::clamp(1 - std::abs(time - 7.3f) / 0.4f, 0.0f, 1.0f);
        return (1 + 2 * late) * (glm::length(p) - 0.5f);
    };
    const FieldReport r = measure(domain(1, {}, true), formula);
    EXPECT_NEAR(r.steepest.value, 3, 0.06f);
    EXPECT_NEAR(r.steepest.time, 7.3f, 0.03f);
    EXPECT_EQ(measure(domain(1, {}, false), formula).steepest.time, 0) << "nothing moves";
}

TEST(FieldSlope, InsideIsToldApart) {
    const FieldReport r = measure(domain(), [](const glm::vec3& p, float, const auto&) {
        const float d = glm::length(p) - 0.5f;
        return d < 0 ? 4 * d : d;
    });
    EXPECT_NEAR(r.steepest.value, 1, 0.01f);
    EXPECT_NEAR(r.steepestInside.value, 4, 0.02f);
    EXPECT_EQ(r.lipschitz, 1);
}

TEST(FieldSlope, AJumpIsNoCrease) {
    const FieldReport r = measure(domain(), [](const glm::vec3& p, float, const auto&) {
        return glm::length(p) - 0.3f + (p.x > 0.4f ? 0.25f : 0.0f);
    });
    EXPECT_NEAR(r.jump, 0.25f, 0.03f);
    EXPECT_NEAR(r.jumpPlace.point.x, 0.4f, 1e-3f);
    EXPECT_LE(r.lipschitz, 4);
}

TEST(FieldSlope, NotANumber) {
    const FieldReport r = measure(
        domain(), [](const glm::vec3& p, float, const auto&) { return std::sqrt(p.x) - 0.5f; });
    EXPECT_GT(r.notFinite, 10000u);
    EXPECT_LT(r.notFinitePlace.point.x, 0.02f);
    const FieldReport nowhere =
        measure(domain(), [](const glm::vec3&, float, const auto&) { return std::nanf(""); });
    EXPECT_GE(nowhere.notFinite, nowhere.samples);
    EXPECT_EQ(nowhere.lipschitz, 1);
}

TEST(FieldSlope, NothingAndNothingElse) {
    const auto constant = [](float value) {
        return measure(domain(), [=](const glm::vec3&, float, const auto&) { return value; });
    };
    EXPECT_FALSE(constant(1).hasSurface());
    EXPECT_TRUE(constant(-1).isSolid());
    // A sheet without a thickness is a surface, though nothing is negative.
    EXPECT_TRUE(measure(domain(), [](const glm::vec3& p, float, const auto&) {
                    return std::abs(glm::length(p) - 0.5f);
                }).hasSurface());
}

TEST(FieldSlope, TheBoundsCutTheSurface) {
    const auto ball = [](float radius) {
        return [=](const glm::vec3& p, float, const auto&) { return glm::length(p) - radius; };
    };
    EXPECT_FALSE(measure(domain(), ball(0.99f)).cut);
    EXPECT_FALSE(measure(domain(), ball(1)).cut) << "it only touches";
    const FieldReport r = measure(domain(), ball(1.1f));
    ASSERT_TRUE(r.cut);
    EXPECT_TRUE(r.cutInUse);
    EXPECT_NEAR(r.cut->value, -0.1f, 0.01f);
    const FieldReport slider =
        measure(domain(1, {test::slider("radius", 0.5f, 0.6f, 1.1f)}),
                [](const glm::vec3& p, float, const auto& s) { return glm::length(p) - s[0].x; });
    ASSERT_TRUE(slider.cut);
    EXPECT_FALSE(slider.cutInUse);
}

TEST(FieldSlope, TheSameEachTime) {
    const auto formula = [](const glm::vec3& p, float, const auto&) {
        return glm::length(p) - 0.5f + 0.05f * std::sin(30 * p.x) * std::sin(30 * p.y);
    };
    const FieldReport a = measure(domain(), formula), b = measure(domain(), formula);
    EXPECT_EQ(a.steepest.value, b.steepest.value);
    EXPECT_EQ(a.steepest.point, b.steepest.point);
    EXPECT_EQ(a.steepShare, b.steepShare);
    // |grad| <= 1 + 0.05 * 30, and nearly that where both point the same way.
    EXPECT_GT(a.steepest.value, 2.4f);
    EXPECT_LE(a.steepest.value, 2.51f);
}

TEST(FieldSlope, TheGridIsAboveAndNear) {
    EXPECT_EQ(safeLipschitz(0), 1);
    EXPECT_EQ(safeLipschitz(1.02f), 1);
    for (float slope = 1.03f; slope < 900; slope *= 1.01f) {
        EXPECT_GE(safeLipschitz(slope), 1.019f * slope);
        EXPECT_LE(safeLipschitz(slope), 1.08f * slope);
    }
    EXPECT_EQ(safeLipschitz(1e9f), 1000);
}

}  // namespace
}  // namespace vitrine
