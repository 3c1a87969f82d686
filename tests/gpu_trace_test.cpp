// SPDX-License-Identifier: MIT
// The shaders' tracer against three others: brute force, the tree on the CPU, and Embree.
//
// Tolerances: see gpu_trace_support.hpp. Rays on the limit, along an edge or starting on a
// triangle, are counted: at most one in a thousand of random rays; hostile ones are there on
// purpose.
#include "bvh/build.hpp"
#include "bvh/test_meshes.hpp"
#include "bvh/traverse.hpp"
#include "embree_scene.hpp"
#include "gpu_support.hpp"
#include "gpu_trace_support.hpp"

namespace vitrine {
namespace {

using test::Answer;
using test::Random;

class TraceTest : public test::GpuTest {};

QueryRay queryOf(const Ray& ray) {
    // The tracer's rays are unit vectors.
    return {ray.origin, 0, glm::normalize(ray.direction)};
}

Ray rayOf(const QueryRay& ray) {
    return {ray.origin, ray.direction, 0, ray.length};
}

Answer answerOf(const test::Mesh& mesh, uint32_t triangle, double t) {
    Answer answer{t, {}};
    for (int i = 0; i < 3; ++i) answer.corners[i] = mesh.positions[mesh.triangles[triangle][i]];
    return answer;
}

std::optional<Answer> answerOf(const test::Mesh& mesh, const glm::uvec4& record) {
    if (!record::isSurface(record)) return {};
    return answerOf(mesh, record.y, record::recordDistance(record));
}

std::optional<Answer> answerOf(const test::Mesh& mesh, const std::optional<TriangleHit>& hit) {
    if (!hit) return {};
    return answerOf(mesh, hit->triangle, hit->t);
}

struct Tally {
    int hits = 0, limits = 0, wrong = 0;
    void add(const Ray& ray, const std::optional<Answer>& ours, const std::optional<Answer>& theirs,
             const char* peer) {
        hits += ours.has_value();
        const test::Verdict verdict = test::compare(ray, ours, theirs);
        limits += verdict == test::Verdict::kOnTheLimit;
        wrong += verdict == test::Verdict::kWrong;
        if (verdict == test::Verdict::kWrong && wrong <= 3)
            ADD_FAILURE() << peer << ": t " << (ours ? ours->t : -1) << " against "
                          << (theirs ? theirs->t : -1) << ", ray " << test::textOf(ray);
    }
};

/// All comparisons of one mesh and one list of rays. `limitShare`: part of the rays that may be
/// on the limit.
void expectAgreement(const Context& context, const test::Mesh& mesh, const std::vector<Ray>& rays,
                     double limitShare, bool bruteForce) {
    test::TestScene scene;
    scene.add(scene.addMesh(mesh.positions, mesh.triangles));
    const PackedScene packed = scene.pack();
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    const EmbreeScene embree(mesh.positions, mesh.triangles, 1, RTC_SCENE_FLAG_ROBUST);
    std::vector<QueryRay> queries;
    for (const Ray& ray : rays) queries.push_back(queryOf(ray));
    for (const Backend backend : test::kBackends) {
        SCOPED_TRACE(test::nameOf(backend));
        RayQuery query(context, packed, backend);
        const auto records = query.closest(queries);
        Tally oracle, brute, robust;
        for (size_t i = 0; i < rays.size(); ++i) {
            const Ray ray = rayOf(queries[i]);
            const auto ours = answerOf(mesh, records[i]);
            const auto found = closestHit(bvh, mesh.positions, mesh.triangles, ray);
            oracle.add(ray, ours, answerOf(mesh, found), "oracle");
            if (bruteForce)
                brute.add(ray, ours,
                          answerOf(mesh, bruteForceClosestHit(mesh.positions, mesh.triangles, ray)),
                          "brute force");
            const EmbreeHit hit = embree.closest(ray);
            std::optional<Answer> theirs;
            if (std::isfinite(hit.t) && hit.t < 1e38f) theirs = answerOf(mesh, hit.triangle, hit.t);
            robust.add(ray, ours, theirs, "Embree");
        }
        const double allowed = limitShare * static_cast<double>(rays.size());
        EXPECT_EQ(oracle.wrong + brute.wrong + robust.wrong, 0);
        EXPECT_LE(oracle.limits, allowed);
        EXPECT_LE(brute.limits, allowed);
        EXPECT_LE(robust.limits, allowed);
        EXPECT_GT(oracle.hits, static_cast<int>(rays.size()) / 50);
    }
}

std::vector<Ray> randomRays(Random& random, int count, float radius) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) rays.push_back(test::ray(random, radius));
    return rays;
}

TEST_F(TraceTest, RandomTriangles) {
    for (const float size : {0.03f, 0.2f, 0.8f}) {
        const uint32_t seed = test::seedOr(101);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const test::Mesh mesh = test::soup(random, 600, 1, size);
        expectAgreement(context(), mesh, randomRays(random, 8000, 1.5f), 1e-3, true);
    }
}

TEST_F(TraceTest, LargeMesh) {
    const uint32_t seed = test::seedOr(102);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const test::Mesh mesh = test::soup(random, 40000, 1, 0.03f);
    expectAgreement(context(), mesh, randomRays(random, 50000, 1.5f), 1e-3, false);
}

TEST_F(TraceTest, HugeAndTinyCoordinates) {
    const uint32_t seed = test::seedOr(103);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (const float scale : {1e6f, 1e-6f}) {
        const test::Mesh mesh = test::soup(random, 600, scale, 0.3f * scale);
        expectAgreement(context(), mesh, randomRays(random, 8000, 1.5f * scale), 1e-3, true);
    }
    test::Mesh mesh = test::soup(random, 600, 1, 0.3f);
    const glm::vec3 far(1e6f, -2e6f, 3e5f);
    for (glm::vec3& p : mesh.positions) p += far;
    std::vector<Ray> rays = randomRays(random, 8000, 1.5f);
    for (Ray& ray : rays) ray.origin += far;
    // Coordinates are whole eighths there: triangles collapse to lines and share planes.
    expectAgreement(context(), mesh, rays, 1.0, true);
}

TEST_F(TraceTest, HostileTrianglesAndRays) {
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        const uint32_t seed = test::seedOr(104);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", scale " + std::to_string(scale));
        Random random(seed);
        const test::Mesh mesh = test::hostileSoup(random, 250, scale);
        std::vector<Ray> rays = randomRays(random, 4000, 5 * scale);
        for (int i = 0; i < 4000; ++i) rays.push_back(test::axisRay(random, scale));
        expectAgreement(context(), mesh, rays, 0.2, true);
    }
}

TEST_F(TraceTest, CoplanarDuplicatesAnswerOnce) {
    test::Mesh mesh;
    for (int copy = 0; copy < 50; ++copy) mesh.add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    test::TestScene scene;
    scene.add(scene.addMesh(mesh.positions, mesh.triangles));
    for (const Backend backend : test::kBackends) {
        RayQuery query(context(), scene.pack(), backend);
        const std::vector<QueryRay> rays(1, {{0, 0, 0}, 0, {0, 0, 1}});
        const auto records = query.closest(rays);
        ASSERT_TRUE(record::isSurface(records[0]));
        EXPECT_EQ(record::recordDistance(records[0]), 2.0f);
    }
}

TEST_F(TraceTest, BarycentricsLeadToThePoint) {
    const uint32_t seed = test::seedOr(105);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const test::Mesh mesh = test::soup(random, 500, 1, 0.5f);
    test::TestScene scene;
    scene.add(scene.addMesh(mesh.positions, mesh.triangles));
    std::vector<QueryRay> rays;
    for (int i = 0; i < 5000; ++i) rays.push_back(queryOf(test::ray(random, 1.5f)));
    for (const Backend backend : test::kBackends) {
        RayQuery query(context(), scene.pack(), backend);
        const auto records = query.closest(rays);
        int hits = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            if (!record::isSurface(records[i])) continue;
            ++hits;
            const glm::uvec3 c = mesh.triangles[records[i].y];
            const glm::vec2 vw = record::unpackBarycentrics(records[i].z);
            const glm::vec3 p = (1 - vw.x - vw.y) * mesh.positions[c.x] +
                                vw.x * mesh.positions[c.y] + vw.y * mesh.positions[c.z];
            const glm::vec3 q =
                rays[i].origin + record::recordDistance(records[i]) * rays[i].direction;
            // 16 bits of an edge of up to 1.7.
            EXPECT_LT(glm::length(p - q), 1e-4f) << "ray " << i;
        }
        EXPECT_GT(hits, 1000);
    }
}

TEST_F(TraceTest, AnyHitIsClosestHitWithinTheLength) {
    const uint32_t seed = test::seedOr(106);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (const float size : {0.05f, 0.4f}) {
        const test::Mesh mesh = test::soup(random, 2000, 1, size);
        test::TestScene scene;
        scene.add(scene.addMesh(mesh.positions, mesh.triangles));
        scene.add(
            scene.addField("// bounds[-0.6, -0.6, -0.6, 0.6, 0.6, 0.6]\n"
                           "float sdf(vec3 p) { return length(p) - 0.5; }"));
        std::vector<QueryRay> rays;
        for (int i = 0; i < 10000; ++i) {
            rays.push_back(queryOf(test::ray(random, 1.5f)));
            rays.back().length = random.integer(0, 3) == 0 ? 3e38f : random.uniform(0, 1.5f);
        }
        std::vector<QueryRay> endless = rays;
        for (QueryRay& ray : endless) ray.length = 3e38f;
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend));
            RayQuery query(context(), scene.pack(), backend);
            const auto any = query.any(rays);
            const auto closest = query.closest(rays);
            const auto first = query.closest(endless);
            int hits = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                const bool hit = record::isSurface(any[i]);
                hits += hit;
                ASSERT_EQ(hit, record::isSurface(closest[i])) << "ray " << i;
                ASSERT_EQ(hit, record::isSurface(first[i]) &&
                                   record::recordDistance(first[i]) < rays[i].length)
                    << "ray " << i;
            }
            EXPECT_GT(hits, 1000);
            EXPECT_LT(hits, 9800);
        }
    }
}

}  // namespace
}  // namespace vitrine
