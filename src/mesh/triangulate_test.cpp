// SPDX-License-Identifier: MIT
#include "mesh/triangulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace vitrine {
namespace {

constexpr uint64_t kPlenty = 1'000'000'000;
using Polygon = std::vector<glm::vec3>;

glm::dvec3 areaVector(const Polygon& p) {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < p.size(); ++i)
        sum += 0.5 * glm::cross(glm::dvec3(p[i]), glm::dvec3(p[(i + 1) % p.size()]));
    return sum;
}

std::vector<glm::uvec3> cut(const Polygon& polygon) {
    std::vector<glm::uvec3> triangles;
    Triangulator(kPlenty).triangulate(polygon, triangles);
    return triangles;
}

/// All triangles wind like the polygon and their areas add up to its area: then they cannot
/// overlap or leave it.
void expectExact(const Polygon& polygon) {
    const std::vector<glm::uvec3> triangles = cut(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    const glm::dvec3 whole = areaVector(polygon);
    const glm::dvec3 axis = glm::normalize(whole);
    double sum = 0.0;
    for (const glm::uvec3& t : triangles) {
        const double area = glm::dot(areaVector({polygon[t.x], polygon[t.y], polygon[t.z]}), axis);
        EXPECT_GE(area, -1e-6 * glm::length(whole)) << t.x << ' ' << t.y << ' ' << t.z;
        sum += std::abs(area);
    }
    EXPECT_NEAR(sum, glm::length(whole), 1e-5 * glm::length(whole));
}

/// In all orientations and windings, from each first corner.
void expectExactHoweverTurned(const std::vector<glm::vec2>& flat) {
    const glm::vec3 ups[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1, 2, 3}};
    for (const glm::vec3& up : ups) {
        const glm::vec3 n = glm::normalize(up);
        const glm::vec3 u = glm::normalize(
            glm::cross(n, std::abs(n.x) > 0.7f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
        for (size_t first = 0; first < flat.size(); ++first) {
            Polygon polygon;
            for (size_t i = 0; i < flat.size(); ++i) {
                const glm::vec2 p = flat[(first + i) % flat.size()];
                polygon.push_back(p.x * u + p.y * glm::cross(n, u));
            }
            expectExact(polygon);
            std::reverse(polygon.begin(), polygon.end());
            expectExact(polygon);
        }
    }
}

TEST(Triangulate, ConcavePolygons) {
    expectExactHoweverTurned({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});  // L
    expectExactHoweverTurned({{0, 0}, {4, 3}, {0, 1}, {-4, 3}});                 // arrow
    expectExactHoweverTurned({{0, 0},
                              {5, 0},
                              {5, 4},
                              {4, 4},
                              {4, 1},
                              {3, 1},
                              {3, 4},
                              {2, 4},
                              {2, 1},
                              {1, 1},
                              {1, 4},
                              {0, 4}});  // comb
    expectExactHoweverTurned({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
    expectExactHoweverTurned(
        {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}});  // a
                                                                                            // hole
}

TEST(Triangulate, RandomStars) {
    for (uint32_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> radius(0.1f, 1.0f);
        const int count = 4 + static_cast<int>(random() % 60);
        Polygon polygon;
        for (int i = 0; i < count; ++i) {
            const float angle = 2.0f * kPi * static_cast<float>(i) / static_cast<float>(count);
            const float r = radius(random);
            polygon.emplace_back(r * std::cos(angle), 0.3f * r * std::cos(angle),
                                 r * std::sin(angle));
        }
        expectExact(polygon);
    }
}

TEST(Triangulate, LongSpiral) {
    Polygon polygon;
    const auto arm = [&polygon](int i, float offset) {
        const float angle = 0.05f * static_cast<float>(i), r = 3.0f + angle + offset;
        polygon.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0f);
    };
    for (int i = 0; i < 2000; ++i) arm(i, 0.0f);
    for (int i = 1999; i >= 0; --i) arm(i, -2.0f);
    expectExact(polygon);
}

TEST(Triangulate, ConvexOnesAreCutCompactly) {
    Polygon circle;
    for (int i = 0; i < 64; ++i) {
        const float angle = 2.0f * kPi * static_cast<float>(i) / 64.0f;
        circle.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
    }
    double edges = 0.0;
    for (const glm::uvec3& t : cut(circle))
        for (int k = 0; k < 3; ++k) edges += glm::distance(circle[t[k]], circle[t[(k + 1) % 3]]);
    EXPECT_LT(edges, 80.0) << "halving the corners round by round gives 72, a fan 164";
    expectExact(circle);
}

TEST(Triangulate, WhatIsNoPolygonStillEnds) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Polygon cases[] = {
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}},
        {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
        {{0, 0, 0}, {nan, 0, 0}, {1, 1, 0}, {0, 1, 0}},
        {{0, 0, 0}, {3e38f, 0, 0}, {3e38f, 3e38f, 0}, {0, -3e38f, 3e38f}},
    };
    for (const Polygon& polygon : cases) EXPECT_EQ(cut(polygon).size(), polygon.size() - 2);
    EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST(Triangulate, StopsSearchingWhenTheBudgetIsSpent) {
    Triangulator triangulator(10);
    std::vector<glm::uvec3> triangles;
    const Polygon comb{{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {4, 4, 0}, {4, 1, 0}, {3, 1, 0},
                       {3, 4, 0}, {2, 4, 0}, {2, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
    triangulator.triangulate(comb, triangles);
    EXPECT_EQ(triangles.size(), comb.size() - 2);
    EXPECT_TRUE(triangulator.exhausted());
}

}  // namespace
}  // namespace vitrine
