// SPDX-License-Identifier: MIT
#include "mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace vitrine {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

Mesh meshOf(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
    return mesh;
}

std::string sanitized(Mesh& mesh) {
    Diagnostics diagnostics;
    sanitizeMesh(mesh, {"m.glb"}, diagnostics);
    return diagnostics.text();
}

void expectSafe(const Mesh& mesh) {
    ASSERT_FALSE(mesh.partNames.empty());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    ASSERT_EQ(mesh.triangleParts.size(), mesh.triangles.size());
    for (const size_t optional : {mesh.uvs2.size(), mesh.colors.size(), mesh.tangents.size()})
        ASSERT_TRUE(optional == 0 || optional == mesh.positions.size());
    for (const glm::vec4& t : mesh.tangents) {
        ASSERT_NEAR(glm::length(glm::vec3(t)), 1.0f, 1e-5f);
        ASSERT_EQ(std::abs(t.w), 1.0f);
    }
    for (const glm::vec4& c : mesh.colors) ASSERT_TRUE(isFinite(c) && std::isfinite(c.w));
    for (const glm::vec2& uv : mesh.uvs2) ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        ASSERT_TRUE(isFinite(mesh.positions[i]));
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
        ASSERT_TRUE(std::isfinite(mesh.uvs[i].x) && std::isfinite(mesh.uvs[i].y));
    }
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3 v = mesh.triangles[t];
        ASSERT_LT(mesh.triangleParts[t], mesh.partNames.size());
        ASSERT_TRUE(v.x < mesh.positions.size() && v.y < mesh.positions.size() &&
                    v.z < mesh.positions.size());
        const glm::vec3 &a = mesh.positions[v.x], &b = mesh.positions[v.y],
                        &c = mesh.positions[v.z];
        ASSERT_FALSE(isDegenerate(a, b, c));
    }
}

TEST(Mesh, BoundsHoldAllPositions) {
    EXPECT_TRUE(bounds(Mesh{}).empty());
    const Mesh mesh = meshOf({{1, 2, 3}, {-1, 5, 0}}, {});
    EXPECT_EQ(bounds(mesh).min, glm::vec3(-1, 2, 0));
    EXPECT_EQ(bounds(mesh).max, glm::vec3(1, 5, 3));
}

TEST(Mesh, DegenerateMeansThatFloatsCannotTellTheNormal) {
    const glm::vec3 o(0.0f), x(1.0f, 0.0f, 0.0f), y(0.0f, 1.0f, 0.0f);
    EXPECT_FALSE(isDegenerate(o, x, y));
    EXPECT_FALSE(isDegenerate(o, x * 1e-8f, y * 1e-8f));
    EXPECT_FALSE(isDegenerate(o, x * 1e17f, y * 1e17f));
    EXPECT_FALSE(isDegenerate(o, x, y * 1e-6f));
    EXPECT_TRUE(isDegenerate(o, x, x));
    EXPECT_TRUE(isDegenerate(o, x, 2.0f * x));
    EXPECT_TRUE(isDegenerate(o, x, y * 1e-8f));
    EXPECT_TRUE(isDegenerate(o, x * 1e-10f, y * 1e-10f));
}

TEST(Mesh, FillsWhatIsMissing) {
    Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(sanitized(mesh), "");
    expectSafe(mesh);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.partNames[0], "default");
}

TEST(Mesh, NormalizesAndRepairsNormalsAndUvs) {
    Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    mesh.normals = {{0, 3e30f, 0}, {kNan, 0, 0}, {0, 0, 1e-30f}};
    mesh.uvs = {{1, 2}, {kNan, 2}, {0, kInf}};
    EXPECT_EQ(sanitized(mesh), "");
    expectSafe(mesh);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.uvs[0], glm::vec2(1, 2));
    EXPECT_EQ(mesh.uvs[1], glm::vec2(0, 0));
}

TEST(Mesh, DropsBadTrianglesWithOneCountedWarningOfEachKind) {
    const std::vector<glm::vec3> points{{0, 0, 0},    {1, 0, 0},     {0, 1, 0},    {2, 0, 0},
                                        {kNan, 0, 0}, {0, -kInf, 0}, {0, 0, 2e18f}};
    Mesh mesh = meshOf(points, {{0, 1, 1}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {0, 1, 6}, {0, 1, 2}});
    mesh.partNames = {"a", "b"};
    mesh.triangleParts = {0, 0, 0, 0, 0, 1};
    EXPECT_EQ(sanitized(mesh),
              "m.glb: warning: 3 triangles dropped: infinite, huge or not-a-number coordinates\n"
              "m.glb: warning: 2 triangles dropped: no area");
    expectSafe(mesh);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.triangleParts[0], 1u) << "parts must move with their triangles";
    EXPECT_EQ(mesh.positions.size(), 3u) << "unused vertices hold the NaNs";
}

TEST(Mesh, IndicesOutOfRangeAreErrors) {
    Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {0, 1, 2}});
    EXPECT_EQ(sanitized(mesh), "m.glb: error: 1 triangle with an index out of range");
    expectSafe(mesh);
    mesh.triangleParts = {1};
    EXPECT_EQ(sanitized(mesh),
              "m.glb: error: 1 triangle with an index out of range\n"
              "m.glb: error: the mesh has no usable triangle left");
}

TEST(Mesh, NoTrianglesIsAnError) {
    Mesh mesh = meshOf({{0, 0, 0}}, {});
    EXPECT_EQ(sanitized(mesh), "m.glb: error: the mesh has no triangles");
}

TEST(Mesh, OptionalArraysMoveWithTheirVertices) {
    // Vertex 0 is unused; at vertex 2 a flat and an upright triangle meet in a sharp edge.
    Mesh mesh =
        meshOf({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 2, 3}, {1, 4, 2}});
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const auto tag = static_cast<float>(i);
        mesh.uvs.emplace_back(tag, 0);
        mesh.uvs2.emplace_back(tag, 1);
        mesh.colors.emplace_back(tag, 0, 0, 1);
        mesh.tangents.emplace_back(i == 2 ? kNan : tag, 0, tag, i == 2 ? -0.5f : 2.0f);
    }
    EXPECT_EQ(sanitized(mesh), "");
    expectSafe(mesh);
    EXPECT_EQ(mesh.positions.size(), 6u) << "four used, two of them split";
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const float tag = mesh.uvs[i].x;
        EXPECT_EQ(mesh.uvs2[i], glm::vec2(tag, 1));
        EXPECT_EQ(mesh.colors[i], glm::vec4(tag, 0, 0, 1));
        EXPECT_EQ(mesh.tangents[i].w, tag == 2 ? -1 : 1);
        if (tag == 2)
            EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[i]), mesh.normals[i]), 0.0f, 1e-6f);
        else
            EXPECT_NEAR(mesh.tangents[i].x, std::sqrt(0.5f), 1e-6f);
    }
}

TEST(Mesh, OptionalArraysAreFilledUpOrStayEmpty) {
    Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(sanitized(mesh), "");
    EXPECT_TRUE(mesh.uvs2.empty() && mesh.colors.empty() && mesh.tangents.empty());
    mesh.uvs2 = {{1, kInf}, {3, 4}};
    mesh.colors = {{0.5f, 0.5f, 0.5f, kNan}, {0, 1, 0, 1}};
    mesh.tangents = {{2, 0, 0, 1}};
    EXPECT_EQ(sanitized(mesh), "");
    expectSafe(mesh);
    EXPECT_EQ(mesh.uvs2, (std::vector<glm::vec2>{{0, 0}, {3, 4}, {0, 0}}));
    EXPECT_EQ(mesh.colors, (std::vector<glm::vec4>{glm::vec4(1), {0, 1, 0, 1}, glm::vec4(1)}));
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1, 0, 0, 1));
}

TEST(Mesh, AnyMeshIsSafeAfterwards) {
    for (uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const auto any = [&random] {
            constexpr float kOdd[] = {0.0f,  -0.0f,  1.0f,  1.0f + 1e-7f, 1e-30f, 1e-9f, 1e9f,
                                      1e18f, -1e18f, 3e38f, kNan,         kInf,   0.5f,  2.0f};
            return kOdd[random() % std::size(kOdd)];
        };
        Mesh mesh;
        for (int i = 0; i < 24; ++i) mesh.positions.emplace_back(any(), any(), any());
        for (int i = 0; i < 20; ++i) mesh.normals.emplace_back(any(), any(), any());
        for (uint32_t i = 0; i < seed % 30; ++i) {
            mesh.uvs2.emplace_back(any(), any());
            mesh.colors.emplace_back(any(), any(), any(), any());
            mesh.tangents.emplace_back(any(), any(), any(), any());
        }
        for (int i = 0; i < 200; ++i)
            mesh.triangles.emplace_back(random() % 25, random() % 25, random() % 25);
        sanitized(mesh);
        expectSafe(mesh);
    }
}

}  // namespace
}  // namespace vitrine
