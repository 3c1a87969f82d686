// SPDX-License-Identifier: MIT
#include "mesh/normals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "mesh/mesh.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

/// Forgets normals, and vertices that only differ in them.
Mesh weldedWithoutNormals(const Mesh& mesh) {
    Mesh result = mesh;
    result.positions.clear();
    for (glm::uvec3& v : result.triangles)
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 p = mesh.positions[v[k]];
            const auto found = std::find(result.positions.begin(), result.positions.end(), p);
            v[k] = static_cast<uint32_t>(found - result.positions.begin());
            if (found == result.positions.end()) result.positions.push_back(p);
        }
    result.normals.assign(result.positions.size(), glm::vec3(0.0f));
    result.uvs.assign(result.positions.size(), glm::vec2(0.0f));
    return result;
}

TEST(Normals, CubeKeepsItsEdges) {
    Mesh mesh = weldedWithoutNormals(makeBox({1, 2, 3}));
    ASSERT_EQ(mesh.positions.size(), 8u);
    fillMissingNormals(mesh);
    EXPECT_EQ(mesh.positions.size(), 24u);
    for (const glm::uvec3& v : mesh.triangles) {
        const glm::vec3 a = mesh.positions[v.x];
        const glm::vec3 flat =
            glm::normalize(glm::cross(mesh.positions[v.y] - a, mesh.positions[v.z] - a));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(glm::dot(mesh.normals[v[k]], flat), 1.0f, 1e-6f);
    }
}

TEST(Normals, SphereIsSmooth) {
    Mesh mesh = weldedWithoutNormals(makeSphere(2.0f, 16));
    const size_t before = mesh.positions.size();
    fillMissingNormals(mesh);
    EXPECT_EQ(mesh.positions.size(), before);
    for (size_t i = 0; i < before; ++i)
        EXPECT_GT(glm::dot(mesh.normals[i], mesh.positions[i] / 2.0f), 0.999f);
}

TEST(Normals, AreWeightedByAngleNotByTriangle) {
    // Around one corner of a cube, the top face is cut into four slivers and the others into one
    // triangle each. With 180 degrees everything is smooth, and the normal is the diagonal.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    for (int i = 1; i < 4; ++i) {
        const double angle = glm::radians(22.5 * i);
        mesh.positions.emplace_back(-std::cos(angle), 0.0, -std::sin(angle));
    }
    mesh.triangles = {{0, 4, 1}, {0, 5, 4}, {0, 6, 5}, {0, 3, 6}, {0, 1, 2}, {0, 2, 3}};
    mesh.normals.resize(mesh.positions.size());
    mesh.uvs.resize(mesh.positions.size());
    fillMissingNormals(mesh, {180.0f, {}});
    const glm::vec3 diagonal = glm::normalize(glm::vec3(1, 1, 1));
    EXPECT_NEAR(std::abs(glm::dot(mesh.normals[0], diagonal)), 1.0f, 1e-6f);
}

TEST(Normals, EqualPositionsAreOnePoint) {
    // Two triangles of a gentle roof that share no index, only places; one place as -0.
    Mesh mesh;
    mesh.positions = {{0, 0, 0},     {0, 0, 1},     {1, -0.2f, 0},
                      {-0.0f, 0, 1}, {0, -0.0f, 0}, {-1, -0.2f, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    mesh.normals.resize(6);
    mesh.uvs.resize(6);
    fillMissingNormals(mesh);
    EXPECT_NEAR(mesh.normals[0].x, 0.0f, 1e-6f);
    EXPECT_NEAR(mesh.normals[0].y, 1.0f, 1e-6f);
    EXPECT_EQ(mesh.normals[0], mesh.normals[4]);
}

TEST(Normals, GivenOnesAreKept) {
    Mesh mesh = makePlane(1, 1);
    mesh.normals[0] = {1, 0, 0};
    mesh.normals[1] = {0, 0, 0};
    fillMissingNormals(mesh);
    EXPECT_EQ(mesh.normals[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.positions.size(), 4u);
}

TEST(Normals, GroupsOverruleTheAngle) {
    const Mesh box = weldedWithoutNormals(makeBox({1, 1, 1}));
    Mesh smooth = box, flat = box, halves = box;
    fillMissingNormals(smooth, {50.0f, std::vector<uint32_t>(12, 1)});
    EXPECT_EQ(smooth.positions.size(), 8u);
    fillMissingNormals(flat, {180.0f, std::vector<uint32_t>(12, Smoothing::kFlat)});
    EXPECT_EQ(flat.positions.size(), 36u);
    std::vector<uint32_t> groups(12, 1);
    std::fill_n(groups.begin(), 2, 2u);
    fillMissingNormals(halves, {50.0f, groups});
    EXPECT_EQ(halves.positions.size(), 12u) << "one face of its own: its four corners twice";
}

TEST(Normals, BackToBackFacesGetTheirOwn) {
    Mesh mesh = makePlane(1, 1);
    mesh.triangles.emplace_back(0, 2, 1);
    mesh.triangles.emplace_back(0, 3, 2);
    mesh.triangleParts.resize(4);
    mesh.normals.assign(4, glm::vec3(0.0f));
    fillMissingNormals(mesh);
    EXPECT_EQ(mesh.positions.size(), 8u);
    EXPECT_EQ(mesh.normals[mesh.triangles[0].x], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[mesh.triangles[2].x], glm::vec3(0, -1, 0));
}

TEST(Normals, ManyTrianglesAroundOneEdgeStayCheap) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}};
    for (uint32_t i = 0; i < 200000; ++i) {
        const float angle = static_cast<float>(i) * 3e-5f;
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
        mesh.triangles.emplace_back(0, 1, i + 2);
    }
    mesh.normals.resize(mesh.positions.size());
    mesh.uvs.resize(mesh.positions.size());
    const auto start = std::chrono::steady_clock::now();
    fillMissingNormals(mesh);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
}

}  // namespace
}  // namespace vitrine
