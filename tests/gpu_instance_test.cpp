// SPDX-License-Identifier: MIT
// Many instances with rotations, non-uniform and mirrored scales against the two-level oracle.
//
// Tolerance: as in gpu_trace_support.hpp, with the corners taken to the world. The oracle inverts
// the same matrices in the same floats; what differs is the order of a few sums, so the rounding
// across the ray is allowed 4 times: twice on the way into the object, and scales of up to 30.
#include "bvh/build.hpp"
#include "bvh/instance.hpp"
#include "bvh/test_meshes.hpp"
#include "gpu_support.hpp"
#include "gpu_trace_support.hpp"

namespace vitrine {
namespace {

using test::Answer;
using test::Random;

class InstanceTest : public test::GpuTest {};

TEST_F(InstanceTest, EqualsTheOracle) {
    for (uint32_t round = 0; round < 4; ++round) {
        const uint32_t seed = test::seedOr(301) + round;
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const test::Mesh meshes[] = {test::sphere(20, 30, 0.5f, {}),
                                     test::soup(random, 200, 0.5f, 0.2f)};
        test::TestScene scene;
        for (const test::Mesh& mesh : meshes) scene.addMesh(mesh.positions, mesh.triangles);
        std::vector<uint32_t> meshOfInstance;
        for (int i = 0; i < 60; ++i) {
            meshOfInstance.push_back(static_cast<uint32_t>(random.integer(0, 1)));
            Node& node = scene.add(static_cast<int>(meshOfInstance.back()));
            node.at = random.point(4);
            node.rotate = random.point(180);
            for (int axis = 0; axis < 3; ++axis)
                node.scale[axis] = std::pow(30.0f, random.uniform(-0.5f, 0.5f)) *
                                   (random.integer(0, 3) == 0 ? -1.0f : 1.0f);
        }
        const PackedScene packed = scene.pack();

        std::vector<Bvh> trees;
        std::vector<MeshView> views;
        for (const test::Mesh& mesh : meshes)
            trees.push_back(buildTriangleBvh(mesh.positions, mesh.triangles));
        for (size_t i = 0; i < trees.size(); ++i)
            views.push_back({&trees[i], meshes[i].positions, meshes[i].triangles});
        std::vector<Instance> instances;
        for (size_t i = 0; i < meshOfInstance.size(); ++i)
            instances.push_back({packed.instances[i].worldFromObject, meshOfInstance[i]});
        const Bvh top = buildInstanceBvh(instances, views);
        const auto answerOf = [&](uint32_t instance, uint32_t triangle, double t) {
            Answer answer{t, {}};
            const MeshView& view = views[instances[instance].mesh];
            for (int i = 0; i < 3; ++i)
                answer.corners[i] =
                    glm::dvec3(glm::dmat4(instances[instance].worldFromObject) *
                               glm::dvec4(view.positions[view.triangles[triangle][i]], 1));
            return std::optional(answer);
        };

        std::vector<QueryRay> rays;
        for (int i = 0; i < 10000; ++i) {
            const Ray ray = test::ray(random, 6);
            rays.push_back({ray.origin, 0, glm::normalize(ray.direction)});
        }
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend));
            RayQuery query(context(), packed, backend);
            const auto records = query.closest(rays);
            int hits = 0, limits = 0, wrong = 0, otherInstance = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                const Ray ray{rays[i].origin, rays[i].direction};
                const auto found = sceneClosestHit(top, instances, views, ray);
                std::optional<Answer> ours, theirs;
                if (record::isSurface(records[i]))
                    ours = answerOf(records[i].x, records[i].y, record::recordDistance(records[i]));
                if (found) theirs = answerOf(found->instance, found->hit.triangle, found->hit.t);
                const test::Verdict verdict = test::compare(ray, ours, theirs, 4 * test::kAcross);
                hits += ours.has_value();
                limits += verdict == test::Verdict::kOnTheLimit;
                if (verdict == test::Verdict::kWrong && ++wrong <= 3)
                    ADD_FAILURE() << "t " << (ours ? ours->t : -1) << " against "
                                  << (theirs ? theirs->t : -1) << ", ray " << test::textOf(ray);
                otherInstance += ours && found && records[i].x != found->instance;
            }
            EXPECT_EQ(wrong, 0);
            EXPECT_GT(hits, 2000);
            EXPECT_LE(limits, 10);
            EXPECT_LE(otherInstance, 10);
        }
    }
}

}  // namespace
}  // namespace vitrine
