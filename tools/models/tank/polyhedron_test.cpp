// SPDX-License-Identifier: MIT
#include "models/tank/polyhedron.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

using Place = std::array<int64_t, 3>;

Place place(const Vec3& p) {
    return {std::llround(p.x * 1e7), std::llround(p.y * 1e7), std::llround(p.z * 1e7)};
}

/// Every edge is there once in each direction.
bool isClosed(const Solid& solid) {
    std::map<std::pair<Place, Place>, int> edges;
    for (const Triangle& t : solid.triangles)
        for (size_t k = 0; k < 3; ++k)
            ++edges[{place(t.corners[k].at), place(t.corners[(k + 1) % 3].at)}];
    for (const auto& [edge, count] : edges) {
        const auto twin = edges.find({edge.second, edge.first});
        if (count != 1 || twin == edges.end()) return false;
    }
    return true;
}

double volume(const Solid& solid) {
    double sum = 0.0;
    for (const Triangle& t : solid.triangles)
        sum += glm::dot(t.corners[0].at, glm::cross(t.corners[1].at, t.corners[2].at)) / 6.0;
    return sum;
}

TEST(Polyhedron, BevelledBoxIsClosedAndALittleSmaller) {
    const Solid solid = bevelled(box({-1, -1, -1}, {1, 1, 1}), 0.1, Material::kPaint);
    EXPECT_EQ(solid.triangles.size(), 44u);
    EXPECT_TRUE(isClosed(solid));
    // Twelve prisms of 0.1 x 0.1 / 2 are cut off, and they share their ends.
    EXPECT_NEAR(volume(solid), 8.0 - 12 * 2 * 0.005, 0.02);
    for (const Triangle& t : solid.triangles)
        for (const Corner& c : t.corners) {
            const Vec3 axis = glm::abs(c.normal);
            EXPECT_NEAR(std::max({axis.x, axis.y, axis.z}), 1.0, 1e-12);
        }
}

TEST(Polyhedron, ConcavePrismIsClosedWhicheverWayItWinds) {
    std::vector<Vec2> outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    for (int i = 0; i < 2; ++i) {
        const Solid solid = bevelled(prism(outline, 0, 2), 0.05, Material::kSteel);
        EXPECT_TRUE(isClosed(solid));
        EXPECT_NEAR(volume(solid), 10.0, 0.1);
        std::ranges::reverse(outline);
    }
}

TEST(Polyhedron, PlanesMakeTheBodyTheyEnclose) {
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            Vec3 n(0.0);
            n[axis] = side;
            planes.push_back({n, 1.0});
        }
    planes.push_back(Plane::at({0.9, 0.9, 0.9}, {1, 1, 1}));
    const Polyhedron body = convex(planes);
    EXPECT_EQ(body.faces.size(), 7u);
    EXPECT_EQ(body.points.size(), 10u);
    EXPECT_TRUE(isClosed(bevelled(body, 0.02, Material::kPaint)));
}

TEST(Round, LatheAndTubesAreClosed) {
    const Solid wheel =
        turnedOnLathe({{-1, 0}, {-1, 2}, {1, 2}, {0.5, 1}, {0.7, 0}}, {Axis::kZ, 20, 0.05});
    EXPECT_TRUE(isClosed(wheel));
    EXPECT_GT(volume(wheel), 0.0);
    EXPECT_TRUE(
        isClosed(turnedOnLathe({{0, 2}, {1, 2}, {1, 1}, {0, 1}}, {Axis::kX, 9, 0.02, true})));
    EXPECT_TRUE(isClosed(bentTube({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, {0.1, 7})));
    std::vector<Vec3> loop;
    for (int i = 0; i < 9; ++i)
        loop.emplace_back(std::cos(kTau * i / 9), std::sin(kTau * i / 9),
                          0.2 * std::sin(2 * kTau * i / 9));
    EXPECT_TRUE(isClosed(bentTube(loop, {0.1, 5, true})));
}

TEST(Solid, MirroringKeepsTheOutsideOutside) {
    const Solid one = bevelled(box({0, 0, 1}, {1, 1, 2}), 0.05, Material::kPaint);
    Solid both;
    both.appendBothSides(one);
    EXPECT_NEAR(volume(both), 2.0 * volume(one), 1e-9);
    EXPECT_TRUE(isClosed(both));
}

}  // namespace
}  // namespace vitrine::tank
