// SPDX-License-Identifier: MIT
#include "mesh/tangents.hpp"

#include <gtest/gtest.h>

#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

glm::vec3 bitangent(const Mesh& mesh, uint32_t vertex) {
    const glm::vec4& t = mesh.tangents[vertex];
    return glm::cross(mesh.normals[vertex], glm::vec3(t)) * t.w;
}

/// Two unit squares side by side in z = 0 that share the edge x = 0, where u is 0: to the right u
/// grows with x, and to the left against it.
Mesh butterfly() {
    Mesh mesh;
    for (const float x : {-1.0f, 0.0f, 1.0f})
        for (const float y : {0.0f, 1.0f}) {
            mesh.positions.emplace_back(x, y, 0);
            mesh.normals.emplace_back(0, 0, 1);
            mesh.uvs.emplace_back(std::abs(x), y);
        }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
    mesh.triangleParts.assign(4, 0);
    mesh.partNames = {"default"};
    return mesh;
}

TEST(Tangents, OfASphereAreItsParallels) {
    Mesh mesh = makeSphere(2);
    generateTangents(mesh, false);
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& n = mesh.normals[i];
        const float parallel = std::hypot(n.x, n.z);
        if (parallel < 0.2f) continue;  // at the poles the triangles' directions differ
        const glm::vec3 east = glm::vec3(n.z, 0, -n.x) / parallel;
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[i]), east), 1, 1e-3f)
            << "its triangles are not symmetric";
        EXPECT_GT(glm::dot(bitangent(mesh, i), glm::vec3(0, 1, 0)), 0) << "v grows northwards";
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[i]), n), 0, 1e-5f);
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1, 1e-5f);
    }
}

TEST(Tangents, VerticesAreSplitWhereThePictureIsMirrored) {
    Mesh mesh = butterfly();
    generateTangents(mesh, false);
    EXPECT_EQ(mesh.positions.size(), 8u) << "the two of the shared edge are there twice";
    EXPECT_EQ(mesh.uvs.size(), 8u);
    for (size_t t = 0; t < 4; ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const uint32_t v = mesh.triangles[t][corner];
            const float side = t < 2 ? -1.0f : 1.0f;
            EXPECT_EQ(mesh.tangents[v], glm::vec4(side, 0, 0, side));
            EXPECT_EQ(bitangent(mesh, v), glm::vec3(0, 1, 0));
        }
}

TEST(Tangents, TurnedInsideOutTheBitangentStillFollowsV) {
    Mesh mesh = butterfly();
    for (glm::vec3& n : mesh.normals) n = -n;
    generateTangents(mesh, false);
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            EXPECT_EQ(bitangent(mesh, t[corner]), glm::vec3(0, 1, 0));
}

TEST(Tangents, TakesTheSecondCoordinatesIfTold) {
    Mesh mesh = butterfly();
    for (const glm::vec3& p : mesh.positions) mesh.uvs2.emplace_back(p.y, -p.x);
    generateTangents(mesh, true);
    EXPECT_EQ(mesh.positions.size(), 6u) << "they are not mirrored";
    for (const glm::vec4& t : mesh.tangents) EXPECT_EQ(t, glm::vec4(0, 1, 0, 1));
}

TEST(Tangents, EqualVerticesAreOne) {
    // Every triangle has corners of its own: without welding, each would have its own direction.
    Mesh sphere = makeSphere(1, 8), loose;
    for (const glm::uvec3& t : sphere.triangles) {
        const auto first = static_cast<uint32_t>(loose.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            loose.positions.push_back(sphere.positions[t[corner]]);
            loose.normals.push_back(sphere.normals[t[corner]]);
            loose.uvs.push_back(sphere.uvs[t[corner]]);
        }
        loose.triangles.emplace_back(first, first + 1, first + 2);
    }
    generateTangents(sphere, false);
    generateTangents(loose, false);
    for (size_t t = 0; t < sphere.triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner)
            EXPECT_EQ(loose.tangents[3 * t + static_cast<size_t>(corner)],
                      sphere.tangents[sphere.triangles[t][corner]]);
}

TEST(Tangents, CoordinatesWithoutADirectionHaveNone) {
    Mesh mesh = butterfly();
    for (glm::vec2& uv : mesh.uvs) uv = glm::vec2(0.5f);
    generateTangents(mesh, false);
    for (const glm::vec4& t : mesh.tangents) EXPECT_EQ(glm::vec3(t), glm::vec3(0));
}

}  // namespace
}  // namespace vitrine
