// SPDX-License-Identifier: MIT
// The tree must give exactly what brute force gives, and closed meshes must not leak.
#include "bvh/traverse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"

namespace vitrine {
namespace {

using test::Mesh;
using test::Random;

std::string describe(const std::optional<TriangleHit>& hit) {
    if (!hit) return "miss";
    return "triangle " + std::to_string(hit->triangle) + " at " + std::to_string(hit->t);
}

void expectLikeBruteForce(const Mesh& mesh, const Bvh& bvh, const Ray& ray) {
    const auto expected = bruteForceClosestHit(mesh.positions, mesh.triangles, ray);
    const auto found = closestHit(bvh, mesh.positions, mesh.triangles, ray);
    ASSERT_EQ(found, expected) << describe(found) << ", brute force: " << describe(expected);
    ASSERT_EQ(anyHit(bvh, mesh.positions, mesh.triangles, ray), expected.has_value());
}

/// Some rays see only a part of themselves.
Ray cut(Ray ray, Random& random) {
    if (random.integer(0, 2) == 0) {
        ray.tMin = random.uniform(0, 0.5f);
        ray.tMax = random.uniform(0.5f, 1.5f);
    }
    return ray;
}

TEST(Traverse, EqualsBruteForceOnRandomTriangles) {
    for (uint32_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Mesh mesh = test::soup(random, 300, 1, random.uniform(0.02f, 0.6f));
        const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
        for (int i = 0; i < 800; ++i)
            expectLikeBruteForce(mesh, bvh, cut(test::ray(random, 1.5f), random));
    }
}

TEST(Traverse, EqualsBruteForceOnHostileTriangles) {
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e6f}) {
        for (uint32_t seed = 0; seed < 6; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", scale " + std::to_string(scale));
            Random random(seed);
            const Mesh mesh = test::hostileSoup(random, 250, scale);
            const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles,
                                             {.maxLeafSize = random.integer(1, 8)});
            for (int i = 0; i < 500; ++i) {
                expectLikeBruteForce(mesh, bvh, cut(test::ray(random, 5 * scale), random));
                expectLikeBruteForce(mesh, bvh, cut(test::axisRay(random, scale), random));
            }
        }
    }
}

TEST(Traverse, EqualsBruteForceFarFromTheOrigin) {
    Random random(4);
    Mesh mesh = test::soup(random, 300, 1, 0.3f);
    for (glm::vec3& p : mesh.positions) p += glm::vec3(1e6f, -2e6f, 3e5f);
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    for (int i = 0; i < 3000; ++i) {
        Ray ray = test::ray(random, 1.5f);
        ray.origin += glm::vec3(1e6f, -2e6f, 3e5f);
        SCOPED_TRACE("seed 4");
        expectLikeBruteForce(mesh, bvh, ray);
    }
}

TEST(Traverse, SmallerNumberWinsATie) {
    Mesh mesh;
    for (int copy = 0; copy < 50; ++copy) mesh.add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles, {.maxLeafSize = 1});
    const auto hit = closestHit(bvh, mesh.positions, mesh.triangles, {{0, 0, 0}, {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->triangle, 0u);
    EXPECT_EQ(hit->t, 2.0f);
}

TEST(Traverse, BarycentricsLeadToThePoint) {
    Random random(8);
    const Mesh mesh = test::soup(random, 500, 1, 0.5f);
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = test::ray(random, 1.5f);
        const auto hit = closestHit(bvh, mesh.positions, mesh.triangles, ray);
        if (!hit) continue;
        ++hits;
        const glm::uvec3 c = mesh.triangles[hit->triangle];
        const glm::vec3 p = (1 - hit->u - hit->v) * mesh.positions[c.x] +
                            hit->u * mesh.positions[c.y] + hit->v * mesh.positions[c.z];
        // Triangles that are seen nearly from the side lose digits along the ray, not across it.
        const glm::vec3 miss = p - (ray.origin + hit->t * ray.direction);
        EXPECT_LT(glm::length(miss), 1e-4f) << "seed 8";
    }
    EXPECT_GT(hits, 500);
}

TEST(Traverse, ClosedMeshesDoNotLeak) {
    struct Place {
        glm::vec3 centre;
        float radius;
    };
    for (const Place& place : {Place{{}, 1}, Place{{}, 1e-6f}, Place{{}, 1e6f},
                               Place{{1e4f, -1e4f, 1e4f}, 1}, Place{{1e6f, 1e6f, -1e6f}, 10}}) {
        SCOPED_TRACE("seed 21, radius " + std::to_string(place.radius));
        Random random(21);
        const Mesh mesh = test::sphere(40, 60, place.radius, place.centre);
        const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
        const auto expectInside = [&](const glm::vec3& origin, const glm::vec3& target) {
            const Ray ray{origin, target - origin};
            EXPECT_TRUE(anyHit(bvh, mesh.positions, mesh.triangles, ray));
            const auto hit = closestHit(bvh, mesh.positions, mesh.triangles, ray);
            ASSERT_TRUE(hit);
            // The wall, not something far behind a leak.
            EXPECT_NEAR(hit->t, 1, 0.2);
        };
        for (int i = 0; i < 3000; ++i) {
            const glm::vec3 origin = place.centre + random.point(0.4f * place.radius);
            const glm::uvec3 t = mesh.triangles[random.integer(0, int(mesh.triangles.size()) - 1)];
            const glm::vec3& a = mesh.positions[t.x];
            const glm::vec3& b = mesh.positions[t.y];
            expectInside(origin, a);
            expectInside(origin, glm::mix(a, b, random.uniform(0, 1)));
            expectInside(place.centre, glm::mix(a, b, 0.5f));
        }
    }
}

/// A wall of columns x rows quads between four corners.
Mesh wall(int columns, int rows, const glm::vec3& corner, const glm::vec3& across,
          const glm::vec3& up) {
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            mesh.positions.push_back(corner + across * (float(column) / float(columns)) +
                                     up * (float(row) / float(rows)));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto a = uint32_t(row * (columns + 1) + column);
            const uint32_t b = a + 1, c = a + uint32_t(columns) + 1, d = c + 1;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({b, d, c});
        }
    }
    return mesh;
}

void expectNoLeak(const Mesh& mesh, const glm::vec3& corner, const glm::vec3& across,
                  const glm::vec3& up, float distance) {
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    Random random(22);
    const glm::vec3 normal = glm::normalize(glm::cross(across, up));
    int leaks = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 target =
            corner + across * random.uniform(0.2f, 0.8f) + up * random.uniform(0.2f, 0.8f);
        const glm::vec3 from = target + distance * (normal + random.point(2));
        leaks += !anyHit(bvh, mesh.positions, mesh.triangles, {from, target - from});
    }
    EXPECT_EQ(leaks, 0) << "seed 22, distance " << distance;
}

TEST(Traverse, DistantWallsDoNotLeak) {
    // Seen from so far away that a cell is not much wider than a rounding error.
    for (const glm::vec3& up : {glm::vec3(0, 1, 0), glm::vec3(0.3f, 0.9f, 0.2f)}) {
        const glm::vec3 corner(-0.5f, -0.5f, 0), across(1, 0, 0);
        const Mesh mesh = wall(200, 200, corner, across, up);
        for (const float distance : {1.0f, 1e2f, 1e3f, 1e4f})
            expectNoLeak(mesh, corner, across, up, distance);
    }
}

TEST(Traverse, SliversDoNotLeak) {
    // A million times as long as wide: in float, all three edge functions may cancel to zero.
    for (const float height : {1e-3f, 3e-5f, 6e-6f, 3e-6f}) {
        const glm::vec3 corner(-0.5f, -0.4f, 0.1f), across(0.9f, 0.7f, 0.2f);
        const glm::vec3 up = height * glm::vec3(-0.7f, 0.9f, 0.1f);
        expectNoLeak(wall(1, 100, corner, across, up), corner, across, up, 1);
    }
}

TEST(Traverse, EqualsBruteForceOnSlivers) {
    // So thin that t is found anywhere along them, and all crossing in one point: t must still lie
    // in the boxes, or the tree finds another one first.
    for (uint32_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Mesh mesh;
        for (int i = 0; i < 60; ++i) {
            const glm::vec3 a = random.point(1) * glm::vec3(1, 0.01f, 1), b = -0.5f * a;
            mesh.add(a, b, glm::mix(a, b, random.uniform(0, 1)) + random.point(3e-7f));
        }
        const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles, {.maxLeafSize = 1});
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 origin = random.point(3);
            expectLikeBruteForce(mesh, bvh, {origin, -origin});
        }
    }
}

TEST(Triangle, SidesOfEdgesAreExact) {
    // Along +z from the origin the shear is the identity, and products of floats are exact in
    // double: the outcome is known. Float alone would take many near misses of slivers for hits.
    Random random(23);
    const ShearedRay ray({{0, 0, 0}, {0, 0, 1}});
    int hits = 0;
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 half = random.point(1) * glm::vec3(1, 1, 0);
        const glm::vec3 z(0, 0, 1);
        const glm::vec3 a = z - half + random.point(1e-7f) * glm::vec3(1, 1, 0);
        const glm::vec3 b = z + half * random.uniform(0.3f, 1);
        const glm::vec3 c =
            glm::mix(a, b, random.uniform(0, 1)) + random.point(1e-7f) * glm::vec3(1, 1, 0);
        const auto edge = [](const glm::vec3& p, const glm::vec3& q) {
            return double(p.x) * double(q.y) - double(p.y) * double(q.x);
        };
        const double edges[] = {edge(c, b), edge(a, c), edge(b, a)};
        const auto [least, most] = std::minmax_element(std::begin(edges), std::end(edges));
        const bool inside = (*least >= 0 || *most <= 0) && *least != *most;
        ASSERT_EQ(intersectLine(ray, a, b, c).has_value(), inside) << "seed 23, triangle " << i;
        hits += inside;
    }
    EXPECT_GT(hits, 1000);
}

TEST(Traverse, OctahedronIsClosedToRaysAlongTheAxes) {
    // They run in the planes of boxes and meet a corner of four triangles.
    Mesh mesh = test::sphere(2, 4, 1, {});
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0f, 1.0f}) {
            for (const float zero : {0.0f, -0.0f}) {
                Ray ray{glm::vec3(0), glm::vec3(zero)};
                ray.direction[axis] = sign;
                const auto hit = closestHit(bvh, mesh.positions, mesh.triangles, ray);
                ASSERT_TRUE(hit) << "axis " << axis << ", sign " << sign;
                EXPECT_NEAR(hit->t, 1, 1e-6);
            }
        }
    }
}

TEST(Traverse, VisitsLittle) {
    Random random(2);
    const Mesh mesh = test::sphere(100, 200, 1, {});
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    TraversalCounters counters;
    for (int i = 0; i < 1000; ++i)
        closestHit(bvh, mesh.positions, mesh.triangles, test::ray(random, 2), &counters);
    EXPECT_LT(counters.nodes, 60u * 1000);
    EXPECT_LT(counters.triangles, 6u * 1000);
}

}  // namespace
}  // namespace vitrine
