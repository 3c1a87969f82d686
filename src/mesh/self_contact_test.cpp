// SPDX-License-Identifier: MIT
#include "mesh/self_contact.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

using Point = glm::i64vec3;
using Triple = std::array<Point, 3>;

Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
int64_t dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
int sign(int64_t x) {
    return (x > 0) - (x < 0);
}
int side(const Point& a, const Point& b, const Point& c, const Point& p) {
    return sign(dot(cross(b - a, c - a), p - a));
}

/// Whole numbers, edges against triangles: exact, and nothing like what is tested.
bool edgeMeets(const Point& p, const Point& q, const Triple& t) {
    const int sp = side(t[0], t[1], t[2], p), sq = side(t[0], t[1], t[2], q);
    if (sp * sq > 0) return false;
    if (sp != 0 || sq != 0) {
        const int s0 = side(p, q, t[0], t[1]), s1 = side(p, q, t[1], t[2]),
                  s2 = side(p, q, t[2], t[0]);
        return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
    }
    const Point n = cross(t[1] - t[0], t[2] - t[0]);
    const auto turn = [&](const Point& a, const Point& b, const Point& c) {
        return sign(dot(n, cross(b - a, c - a)));
    };
    if (turn(t[0], t[1], p) >= 0 && turn(t[1], t[2], p) >= 0 && turn(t[2], t[0], p) >= 0)
        return true;
    const auto between = [](const Point& a, const Point& b, const Point& x) {
        return dot(a - x, b - x) <= 0;
    };
    for (size_t i = 0; i < 3; ++i) {
        const Point &a = t[i], &b = t[(i + 1) % 3];
        const int pa = turn(p, q, a), pb = turn(p, q, b), ap = turn(a, b, p), aq = turn(a, b, q);
        if (pa * pb < 0 && ap * aq < 0) return true;
        if ((pa == 0 && between(p, q, a)) || (pb == 0 && between(p, q, b)) ||
            (ap == 0 && between(a, b, p)) || (aq == 0 && between(a, b, q)))
            return true;
    }
    return false;
}

bool trianglesMeet(const Triple& a, const Triple& b) {
    for (size_t i = 0; i < 3; ++i)
        if (edgeMeets(a[i], a[(i + 1) % 3], b) || edgeMeets(b[i], b[(i + 1) % 3], a)) return true;
    return false;
}

/// Common corners come first.
bool meetBeyondCommonCorners(Triple a, Triple b, size_t common) {
    if (common == 3) return true;
    if (common == 2) {
        const Point na = cross(a[1] - a[0], a[2] - a[0]), nb = cross(b[1] - b[0], b[2] - b[0]);
        return cross(na, nb) == Point(0) && dot(na, nb) > 0;
    }
    if (common == 0) return trianglesMeet(a, b);
    // Without the corner, and as little as can be around it.
    constexpr int64_t kFine = 1024;
    const Point p = kFine * a[0] + (a[1] - a[0]), q = kFine * a[0] + (a[2] - a[0]);
    for (Triple* t : {&a, &b})
        for (Point& corner : *t) corner *= kFine;
    return trianglesMeet({p, a[1], a[2]}, b) || trianglesMeet({p, a[2], q}, b);
}

std::vector<glm::vec3> randomPoints(std::mt19937& random, size_t count, int most) {
    std::vector<glm::vec3> points;
    while (points.size() < count) {
        const auto coordinate = [&] { return static_cast<float>(random() % (most + 1)); };
        const float x = coordinate(), y = coordinate(), z = coordinate();
        points.emplace_back(x, y, z);
    }
    return points;
}

}  // namespace

// Few places for corners, so that triangles often touch, lie in one plane, or share an edge's line.
TEST(SelfContact, TwoTrianglesAgainstWholeNumbers) {
    std::mt19937 random(5);
    for (size_t common = 0; common < 3; ++common) {
        int meeting = 0, apart = 0;
        for (int k = 0; k < 40000; ++k) {
            const std::vector<glm::vec3> points = randomPoints(random, 6 - common, 2 + k % 4);
            Triple a, b;
            glm::uvec3 numbersA(0, 1, 2), numbersB(3, 4, 5);
            for (size_t i = 0; i < 3; ++i) {
                const auto n = static_cast<uint32_t>(i < common ? i : i + 3 - common);
                numbersB[static_cast<int>(i)] = n;
                a[i] = Point(points[i]);
                b[i] = Point(points[n]);
            }
            bool sound = cross(a[1] - a[0], a[2] - a[0]) != Point(0) &&
                         cross(b[1] - b[0], b[2] - b[0]) != Point(0);
            for (size_t i = common; i < 3; ++i)
                for (size_t j = common; j < 3; ++j) sound = sound && a[i] != b[j];
            if (!sound) continue;
            const bool expected = meetBeyondCommonCorners(a, b, common);
            // Whichever of the corners they are and in whatever order.
            for (int turn = 0; turn < k % 3; ++turn)
                numbersB = {numbersB.y, numbersB.z, numbersB.x};
            ASSERT_EQ(meetsItself(std::vector{numbersA, numbersB}, points), expected)
                << common << " common, case " << k;
            ++(expected ? meeting : apart);
        }
        EXPECT_GT(meeting, 1000) << common;
        EXPECT_GT(apart, 1000) << common;
    }
}

TEST(SelfContact, OneOfManyPairsIsFound) {
    std::mt19937 random(6);
    int meeting = 0, apart = 0;
    for (int k = 0; k < 300; ++k) {
        // Small triangles, far fewer than there is room for.
        std::vector<glm::vec3> points;
        std::vector<glm::uvec3> triangles;
        for (uint32_t t = 0; t < 60; ++t) {
            const glm::vec3 at = 2.5f * randomPoints(random, 1, 12)[0];
            for (const glm::vec3& p : randomPoints(random, 3, 3)) points.push_back(at + p);
            triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
        }
        bool expected = false;
        for (size_t i = 0; i < triangles.size(); ++i)
            for (size_t j = 0; j < i; ++j)
                expected = expected || meetsItself(std::vector{triangles[i], triangles[j]}, points);
        EXPECT_EQ(meetsItself(triangles, points), expected);
        ++(expected ? meeting : apart);
    }
    EXPECT_GT(meeting, 30);
    EXPECT_GT(apart, 30);
}

TEST(SelfContact, ASpikeThroughTheOtherSideIsFound) {
    Mesh ring = makeTorus(0.5f, 0.2f, 48, 24);
    // Corners of seams have two numbers; here they are one.
    for (glm::uvec3& t : ring.triangles)
        for (int i = 0; i < 3; ++i)
            for (uint32_t j = 0; j < t[i]; ++j)
                if (glm::distance(ring.positions[j], ring.positions[t[i]]) < 1e-5f) t[i] = j;
    EXPECT_FALSE(meetsItself(ring.triangles, ring.positions));
    uint32_t farthest = 0;
    for (uint32_t i = 0; i < ring.positions.size(); ++i)
        if (ring.positions[i].x > ring.positions[farthest].x) farthest = i;
    // Within the ring's own tube, in the hole, in the tube across it, beyond that.
    for (const float x : {0.31f, -0.29f, -0.31f, -0.71f}) {
        ring.positions[farthest].x = x;
        EXPECT_EQ(meetsItself(ring.triangles, ring.positions), x < 0.3f) << x;
    }
}

TEST(SelfContact, GivesUpOnABundleOfNeedles) {
    // All boxes overlap, though no two triangles meet.
    std::vector<glm::vec3> points;
    std::vector<glm::uvec3> triangles;
    for (uint32_t i = 0; i < 3000; ++i) {
        const float angle = 2.4f * static_cast<float>(i);
        const glm::vec3 at(std::cos(angle), -std::cos(angle), std::sin(angle));
        for (const float along : {0.0f, 1000.0f})
            points.push_back(glm::sqrt(static_cast<float>(i)) * at + along);
        points.push_back(points.back() + glm::vec3(0.01f, 0, 0));
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    EXPECT_FALSE(meetsItself(std::span(triangles).first(100), points));
    EXPECT_TRUE(meetsItself(triangles, points));
}

}  // namespace vitrine
