// SPDX-License-Identifier: MIT
#include "models/ammonite.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace vitrine {
namespace {

using Place = std::array<float, 3>;

Place place(const glm::vec3& p) {
    return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
}

TEST(Ammonite, StandsOnTheFloorAndIsInTheMiddle) {
    const Mesh mesh = makeAmmonite();
    const Aabb box = bounds(mesh);
    EXPECT_EQ(box.min.y, 0.0f);
    EXPECT_NEAR(box.max.y, 1.6f, 1e-5f);
    EXPECT_NEAR(box.centre().x, 0.0f, 1e-5f);
    EXPECT_NEAR(box.centre().z, 0.0f, 1e-5f);
    EXPECT_GE(mesh.triangles.size(), 20000u);
    EXPECT_LE(mesh.triangles.size(), 45000u);
}

TEST(Ammonite, IsClosedAndWindsOneWay) {
    const Mesh mesh = makeAmmonite();
    std::map<std::pair<Place, Place>, int> edges;
    for (const glm::uvec3& v : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            ++edges[{place(mesh.positions[v[k]]), place(mesh.positions[v[(k + 1) % 3]])}];
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
}

TEST(Ammonite, NormalsFitTheTriangles) {
    const Mesh mesh = makeAmmonite();
    Mesh copy = mesh;
    Diagnostics diagnostics;
    sanitizeMesh(copy, {}, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    for (const glm::uvec3& v : mesh.triangles) {
        const glm::vec3 a = mesh.positions[v.x];
        const glm::vec3 flat =
            glm::normalize(glm::cross(mesh.positions[v.y] - a, mesh.positions[v.z] - a));
        for (int k = 0; k < 3; ++k) ASSERT_GT(glm::dot(mesh.normals[v[k]], flat), 0.6f);
    }
}

/// How often the surface goes around `p`: crossings of the line upwards, with their sign.
int windingNumber(const Mesh& mesh, const glm::vec3& p) {
    int sum = 0;
    for (const glm::uvec3& v : mesh.triangles) {
        const glm::dvec3 a = glm::dvec3(mesh.positions[v.x]) - glm::dvec3(p),
                         b = glm::dvec3(mesh.positions[v.y]) - glm::dvec3(p),
                         c = glm::dvec3(mesh.positions[v.z]) - glm::dvec3(p);
        const double ab = a.x * b.z - a.z * b.x, bc = b.x * c.z - b.z * c.x,
                     ca = c.x * a.z - c.z * a.x;
        const double whole = ab + bc + ca;
        const bool crossed = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
        if (crossed && (bc * a.y + ca * b.y + ab * c.y) / whole > 0.0) sum += whole < 0.0 ? 1 : -1;
    }
    return sum;
}

TEST(Ammonite, NowhereCutsThroughItself) {
    const Mesh mesh = makeAmmonite();
    for (size_t t = 0; t < mesh.triangles.size(); t += 37) {
        const glm::uvec3 v = mesh.triangles[t];
        const glm::vec3 &a = mesh.positions[v.x], &b = mesh.positions[v.y],
                        &c = mesh.positions[v.z];
        const glm::vec3 middle = (a + b + c) / 3.0f;
        const float size = std::sqrt(glm::length(glm::cross(b - a, c - a)));
        const glm::vec3 off = glm::normalize(glm::cross(b - a, c - a)) * (0.02f * size);
        ASSERT_EQ(windingNumber(mesh, middle + off), 0) << t;
        ASSERT_EQ(windingNumber(mesh, middle - off), 1) << t;
    }
}

}  // namespace
}  // namespace vitrine
