// SPDX-License-Identifier: MIT
// The shaders' tracer over the trees of all builders gives what brute force gives. Tolerances: see
// gpu_trace_support.hpp.
#include "bvh/test_meshes.hpp"
#include "bvh/traverse.hpp"
#include "gpu_support.hpp"
#include "gpu_trace_support.hpp"

namespace vitrine {
namespace {

using test::Answer;
using test::Random;

class BuildersTest : public test::GpuTest {};

Answer answerOf(const test::Mesh& mesh, uint32_t triangle, double t) {
    Answer answer{t, {}};
    for (int i = 0; i < 3; ++i) answer.corners[i] = mesh.positions[mesh.triangles[triangle][i]];
    return answer;
}

TEST_F(BuildersTest, AllTreesGiveWhatBruteForceGives) {
    const uint32_t seed = test::seedOr(121);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    // Large triangles among small ones: many are cut.
    test::Mesh mesh = test::soup(random, 1500, 1, 0.03f);
    for (int i = 0; i < 60; ++i) mesh.add(random.point(1), random.point(1), random.point(1));
    std::vector<QueryRay> rays;
    std::vector<std::optional<Answer>> expected;
    for (int i = 0; i < 6000; ++i) {
        const Ray ray = test::ray(random, 1.5f);
        rays.push_back({ray.origin, 0, glm::normalize(ray.direction)});
        const auto hit = bruteForceClosestHit(mesh.positions, mesh.triangles,
                                              {rays.back().origin, rays.back().direction});
        expected.emplace_back();
        if (hit) expected.back() = answerOf(mesh, hit->triangle, hit->t);
    }
    for (const TreeBuilder builder :
         {TreeBuilder::kNine, TreeBuilder::kBinned, TreeBuilder::kSpatial}) {
        test::TestScene scene;
        scene.scene.bvh.builder = builder;
        scene.add(scene.addMesh(mesh.positions, mesh.triangles));
        const LoadedScene loaded = scene.load();
        const size_t references = measure(loaded.assets.meshes[0]->bvh).references;
        EXPECT_EQ(references > mesh.triangles.size(), builder == TreeBuilder::kSpatial);
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend) + ", " +
                         kTreeBuilderNames[static_cast<size_t>(builder)]);
            RayQuery query(context(), loaded.packed, backend);
            const auto closest = query.closest(rays);
            const auto any = query.any(rays);
            int hits = 0, wrong = 0, limits = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                std::optional<Answer> found;
                if (record::isSurface(closest[i]))
                    found = answerOf(mesh, closest[i].y, record::recordDistance(closest[i]));
                hits += found.has_value();
                const test::Verdict verdict =
                    test::compare({rays[i].origin, rays[i].direction}, found, expected[i]);
                wrong += verdict == test::Verdict::kWrong;
                limits += verdict == test::Verdict::kOnTheLimit;
                ASSERT_EQ(record::isSurface(any[i]), found.has_value()) << "ray " << i;
            }
            EXPECT_EQ(wrong, 0);
            EXPECT_LE(limits, 6);
            EXPECT_GT(hits, 1000);
        }
    }
}

}  // namespace
}  // namespace vitrine
