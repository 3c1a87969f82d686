// SPDX-License-Identifier: MIT
// The oracle against Embree in robust mode, an independent implementation.
//
// Tolerances: t within 1e-4 of its value, or the points within 1e-6 of the scene's size. Where one
// of the two passes a silhouette and the other does not, the ray must run along an edge: a
// barycentric coordinate of what was hit below 1e-3. That may happen to one ray in a thousand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"
#include "bvh/traverse.hpp"
#include "embree_scene.hpp"

namespace vitrine {
namespace {

using test::Mesh;
using test::Random;

bool nearEdge(const Mesh& mesh, uint32_t triangle, const Ray& ray) {
    const glm::uvec3 c = mesh.triangles[triangle];
    const auto hit = intersectLine(ShearedRay(ray), mesh.positions[c.x], mesh.positions[c.y],
                                   mesh.positions[c.z]);
    return !hit || std::min({hit->u, hit->v, 1 - hit->u - hit->v}) < 1e-3f;
}

void expectLikeEmbree(const Mesh& mesh, float radius, uint32_t seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    const EmbreeScene embree(mesh.positions, mesh.triangles, 1, RTC_SCENE_FLAG_ROBUST);
    Random random(seed);
    constexpr int kRays = 20000;
    int hits = 0;
    int atEdges = 0;
    for (int i = 0; i < kRays; ++i) {
        const Ray ray = test::ray(random, radius);
        const auto ours = closestHit(bvh, mesh.positions, mesh.triangles, ray);
        const EmbreeHit theirs = embree.closest(ray);
        ASSERT_EQ(anyHit(bvh, mesh.positions, mesh.triangles, ray), ours.has_value());
        const bool theyHit = std::isfinite(theirs.t);
        hits += ours.has_value();
        if (!ours && !theyHit) continue;
        if (ours && theyHit) {
            const float difference = std::abs(ours->t - theirs.t);
            if (difference <= 1e-4f * theirs.t) continue;
            if (difference * glm::length(ray.direction) <= 1e-6f * radius) continue;
        }
        ++atEdges;
        const bool excused = (ours && nearEdge(mesh, ours->triangle, ray)) ||
                             (theyHit && nearEdge(mesh, theirs.triangle, ray));
        ASSERT_TRUE(excused) << "ray " << i << ": t " << (ours ? ours->t : -1) << ", Embree "
                             << theirs.t;
    }
    EXPECT_GT(hits, kRays / 10);
    EXPECT_LE(atEdges, kRays / 1000);
}

TEST(Embree, AgreesOnASphere) {
    expectLikeEmbree(test::sphere(60, 90, 1, {}), 1.5f, 31);
}

TEST(Embree, AgreesOnSmallTriangles) {
    Random random(32);
    expectLikeEmbree(test::soup(random, 20000, 1, 0.03f), 1.5f, 32);
}

TEST(Embree, AgreesOnLargeTriangles) {
    Random random(33);
    expectLikeEmbree(test::soup(random, 500, 1, 0.7f), 1.5f, 33);
}

TEST(Embree, AgreesFarAndLarge) {
    Random random(34);
    expectLikeEmbree(test::soup(random, 5000, 1e6f, 1e5f), 1.5e6f, 34);
    expectLikeEmbree(test::soup(random, 5000, 1e-3f, 1e-4f), 1.5e-3f, 35);
}

}  // namespace
}  // namespace vitrine
