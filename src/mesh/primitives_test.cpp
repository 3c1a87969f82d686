// SPDX-License-Identifier: MIT
#include "mesh/primitives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace vitrine {
namespace {

struct Measure {
    double area = 0.0, volume = 0.0;
};

Measure measure(const Mesh& mesh) {
    Measure m;
    for (const glm::uvec3& v : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[v.x]), b(mesh.positions[v.y]), c(mesh.positions[v.z]);
        m.area += 0.5 * glm::length(glm::cross(b - a, c - a));
        m.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return m;
}

using Place = std::array<float, 3>;

/// Each edge is run through once in each direction.
void expectClosed(const Mesh& mesh) {
    std::map<std::pair<Place, Place>, int> edges;
    const auto place = [&mesh](uint32_t i) {
        const glm::vec3 p = mesh.positions[i] + 0.0f;  // -0 becomes 0
        return Place{p.x, p.y, p.z};
    };
    for (const glm::uvec3& v : mesh.triangles)
        for (int k = 0; k < 3; ++k) ++edges[{place(v[k]), place(v[(k + 1) % 3])}];
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        const auto back = edges.find({edge.second, edge.first});
        ASSERT_NE(back, edges.end());
    }
}

/// What sanitizeMesh() promises already holds, and normals fit the triangles.
void expectGood(const Mesh& mesh, double leastCosine) {
    Mesh copy = mesh;
    Diagnostics diagnostics;
    sanitizeMesh(copy, {}, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    EXPECT_EQ(copy.triangles.size(), mesh.triangles.size());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    ASSERT_EQ(mesh.triangleParts.size(), mesh.triangles.size());
    for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
    for (const glm::vec2& uv : mesh.uvs)
        ASSERT_TRUE(uv.x >= 0 && uv.x <= 1.01f && uv.y >= 0 && uv.y <= 1);
    for (const glm::uvec3& v : mesh.triangles) {
        const glm::vec3 a = mesh.positions[v.x];
        const glm::vec3 flat =
            glm::normalize(glm::cross(mesh.positions[v.y] - a, mesh.positions[v.z] - a));
        for (int k = 0; k < 3; ++k) ASSERT_GT(glm::dot(mesh.normals[v[k]], flat), leastCosine);
    }
}

/// In uv space triangles turn as in space: pictures are not mirrored.
void expectNotMirrored(const Mesh& mesh) {
    for (const glm::uvec3& v : mesh.triangles) {
        const glm::vec2 ab = mesh.uvs[v.y] - mesh.uvs[v.x], ac = mesh.uvs[v.z] - mesh.uvs[v.x];
        ASSERT_GT(ab.x * ac.y - ab.y * ac.x, 0.0f);
    }
}

TEST(Primitives, Box) {
    const Mesh mesh = makeBox({1, 2, 3});
    expectClosed(mesh);
    expectGood(mesh, 0.999);
    expectNotMirrored(mesh);
    EXPECT_NEAR(measure(mesh).area, 88.0, 1e-4);
    EXPECT_NEAR(measure(mesh).volume, 48.0, 1e-4);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.normals[i].y == 0.0f) {
            EXPECT_EQ(mesh.uvs[i].y > 0.5f, mesh.positions[i].y > 0.0f);
        }
}

TEST(Primitives, Sphere) {
    const Mesh mesh = makeSphere(2.0f, 64);
    expectClosed(mesh);
    expectGood(mesh, 0.998);
    expectNotMirrored(mesh);
    EXPECT_NEAR(measure(mesh).area, 16.0 * kPi, 0.1);
    EXPECT_NEAR(measure(mesh).volume, 32.0 / 3.0 * kPi, 0.1);
    EXPECT_EQ(bounds(mesh).min, glm::vec3(-2.0f));
    EXPECT_EQ(bounds(mesh).max, glm::vec3(2.0f));
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        ASSERT_LT(glm::distance(mesh.positions[i], 2.0f * mesh.normals[i]), 1e-6f);
}

TEST(Primitives, Plane) {
    const Mesh mesh = makePlane(3.0f, 2.0f);
    expectGood(mesh, 0.999);
    expectNotMirrored(mesh);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_NEAR(measure(mesh).area, 24.0, 1e-5);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
}

TEST(Primitives, Torus) {
    const Mesh mesh = makeTorus(2.0f, 0.5f, 128, 64);
    expectClosed(mesh);
    expectGood(mesh, 0.99);
    expectNotMirrored(mesh);
    EXPECT_NEAR(measure(mesh).area, 4.0 * kPi * kPi, 0.1);
    EXPECT_NEAR(measure(mesh).volume, kPi * kPi, 0.05);
    EXPECT_EQ(bounds(mesh).max, glm::vec3(2.5f, 0.5f, 2.5f));
}

TEST(Primitives, PartOfATorus) {
    for (const float arc : {1.0f, 90.0f, 180.0f, 300.0f}) {
        const Mesh mesh = makeTorus(2.0f, 0.5f, 128, 64, arc);
        expectClosed(mesh);
        expectNotMirrored(mesh);
        EXPECT_NEAR(measure(mesh).volume, kPi * kPi * arc / 360, 0.05 * arc / 360);
        EXPECT_NEAR(measure(mesh).area, 4.0 * kPi * kPi * arc / 360 + 0.5 * kPi, 0.1);
    }
    const Mesh half = makeTorus(2.0f, 0.5f, 32, 16, 180);
    expectGood(half, 0.97);
    EXPECT_EQ(bounds(half).min, glm::vec3(-2.5f, -0.5f, -2.5f));
    EXPECT_EQ(bounds(half).max, glm::vec3(2.5f, 0.5f, 0.0f));
}

TEST(Primitives, Cylinder) {
    const Mesh mesh = makeCylinder(1.5f, 2.0f, 128);
    expectClosed(mesh);
    expectGood(mesh, 0.99);
    expectNotMirrored(mesh);
    EXPECT_NEAR(measure(mesh).area, 2.0 * kPi * 1.5 * (1.5 + 4.0), 0.05);
    EXPECT_NEAR(measure(mesh).volume, kPi * 1.5 * 1.5 * 4.0, 0.05);
    EXPECT_EQ(mesh.partNames, (std::vector<std::string>{"side", "top", "bottom"}));
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const float y = mesh.normals[mesh.triangles[t].x].y;
        EXPECT_EQ(mesh.triangleParts[t], y == 0.0f ? 0u : y > 0.0f ? 1u : 2u);
    }
}

TEST(Primitives, SmallCountsStillMakeASolid) {
    for (const Mesh& mesh : {makeSphere(1, 0), makeTorus(2, 1, -5, 1), makeCylinder(1, 1, 2)}) {
        expectClosed(mesh);
        EXPECT_GT(measure(mesh).volume, 0.5);
    }
}

}  // namespace
}  // namespace vitrine
