// SPDX-License-Identifier: MIT
#include "bvh/instance.hpp"

#include <gtest/gtest.h>

#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"

namespace vitrine {
namespace {

using test::Random;

glm::mat4 randomTransform(Random& random) {
    glm::mat4 m = glm::translate(glm::mat4(1), random.point(10));
    m = glm::rotate(m, random.uniform(0, 6), glm::normalize(random.point(1) + glm::vec3(0, 0, 2)));
    // Mirrored and stretched ones too.
    return glm::scale(
        m, glm::vec3(random.uniform(0.3f, 2), random.uniform(0.3f, 2), random.uniform(-2, -0.3f)));
}

TEST(Instances, EqualAskingEveryInstance) {
    Random random(9);
    const test::Mesh meshes[] = {test::sphere(12, 20, 1, {}), test::soup(random, 100, 1, 0.4f)};
    const Bvh trees[] = {buildTriangleBvh(meshes[0].positions, meshes[0].triangles),
                         buildTriangleBvh(meshes[1].positions, meshes[1].triangles), Bvh{}};
    const MeshView views[] = {{&trees[0], meshes[0].positions, meshes[0].triangles},
                              {&trees[1], meshes[1].positions, meshes[1].triangles},
                              {&trees[2], {}, {}}};
    std::vector<Instance> instances;
    for (int i = 0; i < 60; ++i)
        instances.push_back({randomTransform(random), uint32_t(random.integer(0, 2))});
    instances.push_back(instances[5]);  // a tie at every point
    const Bvh tree = buildInstanceBvh(instances, views);

    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const Ray ray = test::ray(random, 12);
        std::optional<SceneHit> expected;
        for (uint32_t k = 0; k < instances.size(); ++k) {
            const MeshView& mesh = views[instances[k].mesh];
            const Ray local = transformed(ray, glm::inverse(instances[k].worldFromObject));
            const auto hit = closestHit(*mesh.bvh, mesh.positions, mesh.triangles, local);
            if (hit && (!expected || hit->t < expected->hit.t)) expected = SceneHit{*hit, k};
        }
        hits += expected.has_value();
        ASSERT_EQ(sceneClosestHit(tree, instances, views, ray), expected) << "seed 9, ray " << i;
    }
    EXPECT_GT(hits, 1000);
}

TEST(Instances, BoxHoldsTheExactCorners) {
    Random random(10);
    for (int i = 0; i < 2000; ++i) {
        Aabb meshBox;
        for (int k = 0; k < 2; ++k) meshBox.grow(random.point(3));
        const glm::mat4 worldFromObject =
            glm::translate(glm::mat4(1), random.point(1e4f)) * randomTransform(random);
        const Aabb box = instanceBox(meshBox, worldFromObject);
        for (int corner = 0; corner < 8; ++corner) {
            glm::dvec4 p(0, 0, 0, 1);
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = (corner >> axis & 1 ? meshBox.max : meshBox.min)[axis];
            const glm::dvec4 exact = glm::dmat4(worldFromObject) * p;
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_LE(double(box.min[axis]), exact[axis]) << "seed 10";
                ASSERT_GE(double(box.max[axis]), exact[axis]) << "seed 10";
            }
        }
    }
}

TEST(Instances, DistanceIsOfTheWorldRay) {
    const test::Mesh mesh = test::sphere(40, 60, 1, {});
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    const MeshView view{&bvh, mesh.positions, mesh.triangles};
    glm::mat4 worldFromObject = glm::translate(glm::mat4(1), {0, 0, -10});
    worldFromObject = glm::scale(worldFromObject, glm::vec3(3));
    const Instance instance{worldFromObject, 0};
    const Bvh tree = buildInstanceBvh({&instance, 1}, {&view, 1});
    const auto hit = sceneClosestHit(tree, {&instance, 1}, {&view, 1}, {{0, 0, 0}, {0, 0, -2}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->hit.t, 3.5, 1e-2);
}

TEST(Instances, NoneIsAMiss) {
    const Bvh tree = buildInstanceBvh({}, {});
    EXPECT_FALSE(sceneClosestHit(tree, {}, {}, {{0, 0, 0}, {0, 0, 1}}));
}

}  // namespace
}  // namespace vitrine
