// SPDX-License-Identifier: MIT
#include "mesh/shells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

Mesh without(Mesh mesh, size_t triangle) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
    return mesh;
}

Mesh insideOut(Mesh mesh) {
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

Mesh joined(const Mesh& a, const Mesh& b, const glm::vec3& shift) {
    Mesh mesh = a;
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : b.positions) mesh.positions.push_back(p + shift);
    for (const glm::uvec3& t : b.triangles) mesh.triangles.push_back(t + first);
    return mesh;
}

/// The plainest of tracers, in double: is the first triangle that a ray meets seen from behind?
bool meetsBackFirst(const Mesh& mesh, const glm::dvec3& eye, const glm::dvec3& direction) {
    double nearest = std::numeric_limits<double>::infinity();
    bool back = false;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a = glm::dvec3(mesh.positions[t.x]) - eye,
                         b = glm::dvec3(mesh.positions[t.y]) - eye,
                         c = glm::dvec3(mesh.positions[t.z]) - eye;
        const double u = glm::dot(direction, glm::cross(b, c)),
                     v = glm::dot(direction, glm::cross(c, a)),
                     w = glm::dot(direction, glm::cross(a, b));
        if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) continue;
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double distance = glm::dot(a, n) / glm::dot(direction, n);
        if (!(distance > 0 && distance < nearest)) continue;
        nearest = distance;
        back = glm::dot(direction, n) > 0;
    }
    return back;
}

/// Looks at every part of the mesh's box.
bool seesBacks(const Mesh& mesh, const glm::vec3& eye) {
    const Aabb box = bounds(mesh);
    // Divisors that hit no edge of a mesh with round coordinates.
    constexpr int kSteps = 13;
    for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
        const glm::dvec3 share = (glm::dvec3(i % kSteps, i / kSteps % kSteps, i / kSteps / kSteps) +
                                  glm::dvec3(0.4567, 0.5432, 0.5123)) /
                                 double(kSteps);
        const glm::dvec3 at = glm::mix(glm::dvec3(box.min), glm::dvec3(box.max), share);
        if (meetsBackFirst(mesh, eye, at - glm::dvec3(eye))) return true;
    }
    return false;
}

/// A box of size 1 without the sides that look along +axis and -axis.
Mesh openAlong(int axis) {
    Mesh mesh = makeBox(glm::vec3(0.5f));
    std::erase_if(mesh.triangles,
                  [&](const glm::uvec3& t) { return std::abs(mesh.normals[t.x][axis]) > 0.5f; });
    return mesh;
}

/// A prism along z over a letter U, which is no star about any point.
Mesh letterU() {
    const std::vector<glm::vec2> outline{{-2, -2}, {2, -2},  {2, 2},  {1, 2},
                                         {1, -1},  {-1, -1}, {-1, 2}, {-2, 2}};
    constexpr std::array<glm::uvec3, 6> kFace{
        {{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7}}};
    Mesh mesh;
    const auto n = static_cast<uint32_t>(outline.size());
    for (const float z : {-0.5f, 0.5f})
        for (const glm::vec2& p : outline) mesh.positions.emplace_back(p, z);
    for (const glm::uvec3& t : kFace) {
        mesh.triangles.push_back(t + n);
        mesh.triangles.push_back({t.x, t.z, t.y});
    }
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t j = (i + 1) % n;
        mesh.triangles.push_back({i, j, j + n});
        mesh.triangles.push_back({i, j + n, i + n});
    }
    return mesh;
}

}  // namespace

TEST(Shells, SolidsAreFound) {
    const glm::vec3 outside(3, 2, 1), inside(0.1f, 0, 0);
    for (const Mesh& mesh :
         {makeBox(glm::vec3(0.5f)), makeSphere(0.5f, 12), makeCylinder(0.4f, 0.5f, 16)}) {
        const Shells found = findShells(mesh);
        ASSERT_EQ(found.shells.size(), 1u);
        EXPECT_EQ(found.shells[0].count, mesh.triangles.size());
        EXPECT_TRUE(found.shells[0].holes.empty());
        EXPECT_TRUE(found.shells[0].hidesBacks(outside));
        EXPECT_FALSE(found.shells[0].hidesBacks(inside));
    }
}

TEST(Shells, SolidsThatAreNoStarsAreFound) {
    for (const Mesh& mesh : {letterU(), makeTorus(1.5f, 0.6f, 24, 12)}) {
        const Shells found = findShells(mesh);
        ASSERT_EQ(found.shells.size(), 1u);
        EXPECT_EQ(found.shells[0].count, mesh.triangles.size());
        for (const glm::vec3& eye : {glm::vec3(0.3f, 6, 0.2f), glm::vec3(4, -5, 3)}) {
            EXPECT_FALSE(seesBacks(mesh, eye));
            EXPECT_TRUE(found.shells[0].hidesBacks(eye));
        }
        EXPECT_TRUE(findShells(insideOut(mesh)).shells.empty());
    }
    // Between the legs one is outside, and yet not known to be.
    EXPECT_FALSE(findShells(letterU()).shells[0].hidesBacks({0, 1, 0}));
}

TEST(Shells, ALegThroughTheOtherIsNoSolid) {
    Mesh mesh = letterU();
    EXPECT_EQ(findShells(mesh).shells.size(), 1u);
    for (glm::vec3& p : mesh.positions)
        if (p.y == 2.0f && p.x > 0) p.x -= 3.2f;
    EXPECT_TRUE(findShells(mesh).shells.empty());
}

/// A box without a lid, whose floor is drawn up into a point that stands out of it. From beside it
/// one sees the floor's back, though the hole looks up.
TEST(Shells, WhatStandsOutOfAHoleIsSeen) {
    for (const float height : {0.2f, 1.5f}) {
        Mesh mesh;
        mesh.positions = {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1},   {-1, 1, -1},
                          {1, 1, -1},   {1, 1, 1},   {-1, 1, 1}, {0, height, 0}};
        for (uint32_t i = 0; i < 4; ++i) {
            const uint32_t j = (i + 1) % 4;
            mesh.triangles.push_back({i, i + 4, j + 4});
            mesh.triangles.push_back({i, j + 4, j});
            mesh.triangles.push_back({i, j, 8});
        }
        const glm::vec3 beside(5, 0.9f, 1);
        const Shells found = findShells(mesh);
        EXPECT_EQ(seesBacks(mesh, beside), height > 1);
        EXPECT_EQ(found.shells.size() == 1 && found.shells[0].hidesBacks(beside), height < 1);
    }
}

/// Whatever is taken away from solids: no back is left out that is seen.
TEST(Shells, NoSeenBackIsHidden) {
    std::mt19937 random(3);
    const auto share = [&] { return static_cast<float>(random() % 1000) / 1000; };
    int hidden = 0, seen = 0;
    for (int k = 0; k < 120; ++k) {
        Mesh mesh = k % 3 == 0   ? letterU()
                    : k % 3 == 1 ? makeTorus(1.5f, 0.6f, 7, 5)
                                 : makeCylinder(1, 1.5f, 7);
        for (glm::vec3& p : mesh.positions) p.x += 0.4f * p.y * p.y;  // bent
        for (size_t gone = random() % 4; gone > 0; --gone)
            mesh = without(mesh, random() % mesh.triangles.size());
        const Shells found = findShells(mesh);
        const glm::vec3 eye = 8.0f * glm::vec3(share() - 0.5f, share() - 0.5f, share() - 0.5f);
        bool all = !found.shells.empty();
        uint32_t count = 0;
        for (const Shell& shell : found.shells) {
            all = all && shell.hidesBacks(eye);
            count += shell.count;
        }
        all = all && count == mesh.triangles.size();
        const bool sees = seesBacks(mesh, eye);
        EXPECT_FALSE(all && sees) << k;
        hidden += all ? 1 : 0;
        seen += sees ? 1 : 0;
    }
    EXPECT_GT(hidden, 25);
    EXPECT_GT(seen, 25);
}

TEST(Shells, WhatIsNoSolidIsNot) {
    EXPECT_TRUE(findShells(insideOut(makeBox(glm::vec3(0.5f)))).shells.empty());
    EXPECT_TRUE(findShells(insideOut(makeTorus(0.5f, 0.2f, 16, 8))).shells.empty());
    Mesh turned = makeBox(glm::vec3(0.5f));
    std::swap(turned.triangles[3].y, turned.triangles[3].z);
    EXPECT_TRUE(findShells(turned).shells.empty());
    EXPECT_TRUE(findShells(makePlane(1, 1)).shells.empty());
}

TEST(Shells, TwiceAroundIsNoSolid) {
    // Two boxes in one place, each cut along an edge and joined to the other there.
    Mesh mesh = joined(makeBox(glm::vec3(0.5f)), makeBox(glm::vec3(0.5f)), glm::vec3(0));
    EXPECT_TRUE(findShells(mesh).shells.empty());
}

TEST(Shells, BacksAreSeenThroughAHole) {
    const Mesh whole = makeBox(glm::vec3(0.5f));
    for (size_t t = 0; t < whole.triangles.size(); ++t) {
        const glm::uvec3 gone = whole.triangles[t];
        const glm::vec3 middle =
            (whole.positions[gone.x] + whole.positions[gone.y] + whole.positions[gone.z]) / 3.0f;
        const Shells found = findShells(without(whole, t));
        ASSERT_EQ(found.shells.size(), 1u);
        EXPECT_FALSE(found.shells[0].hidesBacks(4.0f * middle)) << t;
        EXPECT_TRUE(found.shells[0].hidesBacks(-4.0f * middle)) << t;
        EXPECT_TRUE(found.shells[0].hidesBacks(glm::vec3(-3, -3, -3) * glm::sign(middle))) << t;
    }
}

TEST(Shells, BacksAreSeenThroughEitherOfTwoHoles) {
    for (int axis = 0; axis < 3; ++axis) {
        const Mesh tube = openAlong(axis);
        const Shells found = findShells(tube);
        ASSERT_EQ(found.shells.size(), 1u);
        glm::vec3 along(0), across(0);
        along[axis] = 1;
        across[(axis + 1) % 3] = 1;
        struct Look {
            glm::vec3 eye;
            bool backs;
        };
        for (const Look& look :
             {Look{2.0f * along + 0.3f * across, true}, Look{-2.0f * along + 0.3f * across, true},
              Look{2.0f * across + 0.3f * along, false},
              Look{-2.0f * across - 0.3f * along, false}}) {
            EXPECT_EQ(seesBacks(tube, look.eye), look.backs) << axis;
            EXPECT_EQ(found.shells[0].hidesBacks(look.eye), !look.backs) << axis;
        }
        // Beside the tube and beyond its end: backs are seen from there if it looks in.
        for (const float beyond : {-0.7f, 0.7f}) {
            const glm::vec3 eye = beyond * along + 0.9f * across;
            EXPECT_TRUE(seesBacks(tube, eye)) << axis;
            EXPECT_FALSE(found.shells[0].hidesBacks(eye)) << axis;
        }
    }
}

TEST(Shells, EveryTriangleIsInTheOrderOnce) {
    const Mesh mesh =
        joined(joined(makeTorus(0.5f, 0.2f, 16, 8), makeBox(glm::vec3(0.5f)), glm::vec3(2, 0, 0)),
               makeSphere(0.3f, 8), glm::vec3(4, 0, 0));
    const Shells found = findShells(mesh);
    EXPECT_EQ(found.shells.size(), 3u);
    std::vector<uint32_t> sorted = found.order, all(mesh.triangles.size());
    std::sort(sorted.begin(), sorted.end());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(sorted, all);
    for (const Shell& shell : found.shells)
        for (uint32_t i = shell.first; i < shell.first + shell.count; ++i)
            EXPECT_GE(mesh.positions[mesh.triangles[found.order[i]].x].x, shell.box.min.x);
}

}  // namespace vitrine
