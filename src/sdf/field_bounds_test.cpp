// SPDX-License-Identifier: MIT
// Fields whose extent is known on paper.
#include "sdf/field_bounds.hpp"

#include <gtest/gtest.h>

#include "sdf/field_formula.hpp"

namespace vitrine {
namespace {

using Outcome = FoundBounds::Outcome;

FoundBounds find(const test::Formula& formula, std::vector<Parameter> parameters = {},
                 bool moves = false) {
    Snippet snippet;
    snippet.parameters = std::move(parameters);
    snippet.usesTime = moves;
    return findBounds(domainOf(snippet, {}, {}), test::answering(formula));
}

/// The box holds `inner` and is no more than a tenth of its size larger.
void expectAround(const FoundBounds& found, const Aabb& inner, float slack = 0.1f) {
    ASSERT_EQ(found.outcome, Outcome::kFound);
    const glm::vec3 e = inner.extent();
    const float size = std::max({e.x, e.y, e.z});
    for (int c = 0; c < 3; ++c) {
        EXPECT_LE(found.box.min[c], inner.min[c]) << c;
        EXPECT_GE(found.box.min[c], inner.min[c] - slack * size) << c;
        EXPECT_GE(found.box.max[c], inner.max[c]) << c;
        EXPECT_LE(found.box.max[c], inner.max[c] + slack * size) << c;
    }
}

test::Formula ball(const glm::vec3& centre, float radius, float scale = 1) {
    return [=](const glm::vec3& p, float, const auto&) {
        return scale * (glm::length(p - centre) - radius);
    };
}

Aabb boxOf(const glm::vec3& centre, float radius) {
    return {centre - radius, centre + radius};
}

TEST(FieldBounds, OfBalls) {
    for (const float radius : {2e-3f, 0.1f, 1.0f, 90.0f})
        for (const glm::vec3 centre : {glm::vec3(0), glm::vec3(0.3f, 2, -1), glm::vec3(60, -7, 50)})
            if (glm::length(centre) < 500 * radius)
                expectAround(find(ball(centre, radius)), boxOf(centre, radius));
}

TEST(FieldBounds, OfFieldsThatAreNoDistance) {
    for (const float scale : {0.1f, 0.5f, 3.0f, 30.0f})
        expectAround(find(ball({1, 0, 0}, 0.5f, scale)), boxOf({1, 0, 0}, 0.5f));
    // A long ellipsoid, by the bound of Quilez.
    const glm::vec3 axes(2, 0.1f, 0.4f);
    expectAround(find([=](const glm::vec3& p, float, const auto&) {
                     const float k0 = glm::length(p / axes), k1 = glm::length(p / (axes * axes));
                     return k1 > 0 ? k0 * (k0 - 1) / k1 : -0.1f;
                 }),
                 {-axes, axes});
}

TEST(FieldBounds, OverSlidersAndTime) {
    expectAround(
        find([](const glm::vec3& p, float, const auto& s) { return glm::length(p) - s[0].x; },
             {test::slider("radius", 0.1f, 0.3f, 2)}),
        boxOf({}, 2));
    expectAround(find(
                     [](const glm::vec3& p, float time, const auto&) {
                         return glm::length(p - glm::vec3(0, 3 * std::sin(time), 0)) - 0.5f;
                     },
                     {}, true),
                 {{-0.5f, -3.5f, -0.5f}, {0.5f, 3.5f, 0.5f}});
}

TEST(FieldBounds, OfAThinSpike) {
    // A needle of 1/250 of its length out of a ball: found by pressing outwards.
    const auto spiked = [](const glm::vec3& p, float, const auto&) {
        const glm::vec3 q = p - glm::vec3(0, glm::clamp(p.y, 0.0f, 2.5f), 0);
        return std::min(glm::length(p) - 0.5f, glm::length(q) - 0.01f);
    };
    expectAround(find(spiked), {{-0.5f, -0.5f, -0.5f}, {0.5f, 2.51f, 0.5f}});
}

TEST(FieldBounds, OfAShortLeap) {
    // For a tenth of a second, highest at 7.3 s: few samples see it, and none its height.
    expectAround(find(
                     [](const glm::vec3& p, float time, const auto&) {
                         const float leap = std::max(1 - std::abs(time - 7.3f) / 0.06f, 0.0f);
                         return glm::length(p - glm::vec3(0, 3 * leap, 0)) - 0.5f;
                     },
                     {}, true),
                 {{-0.5f, -0.5f, -0.5f}, {0.5f, 3.5f, 0.5f}});
}

TEST(FieldBounds, OfASheetWithoutThickness) {
    expectAround(find([](const glm::vec3& p, float, const auto&) {
                     const float side = std::max(std::abs(p.x), std::abs(p.z)) - 1;
                     return glm::length(glm::vec2(std::max(side, 0.0f), p.y));
                 }),
                 {{-1, 0, -1}, {1, 0, 1}});
}

TEST(FieldBounds, InfiniteFields) {
    const std::vector<test::Formula> fields{
        [](const glm::vec3& p, float, const auto&) { return p.y; },
        [](const glm::vec3& p, float, const auto&) {
            return glm::length(glm::vec2(p.x, p.z)) - 0.5f;
        },
        [](const glm::vec3& p, float, const auto&) {
            return glm::length(glm::mod(p + 2.0f, 4.0f) - 2.0f) - 0.5f;
        },
        [](const glm::vec3& p, float, const auto&) { return 0.5f - glm::length(p); }};
    for (const auto& field : fields) EXPECT_EQ(find(field).outcome, Outcome::kInfinite);
}

TEST(FieldBounds, NothingThere) {
    for (const float value : {1.0f, std::nanf("")})
        EXPECT_EQ(find([=](const glm::vec3&, float, const auto&) { return value; }).outcome,
                  Outcome::kNothing);
}

}  // namespace
}  // namespace vitrine
