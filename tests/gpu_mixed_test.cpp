// SPDX-License-Identifier: MIT
// Meshes and fields in one another: the closest of both is the nearer of the separate answers. No
// tolerance: the records are the same to the bit, but for the instance's number.
#include "bvh/test_meshes.hpp"
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

using test::Random;

class MixedTest : public test::GpuTest {
  protected:
    /// Adds the pair to scenes: both, the first alone, the second alone.
    struct Pair {
        test::TestScene both, first, second;
    };

    void expectNearerOfBoth(const Pair& pair, uint32_t seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        std::vector<QueryRay> rays;
        for (int i = 0; i < 20000; ++i) {
            const Ray ray = test::ray(random, 2.5f);
            rays.push_back({ray.origin, 1e-3f, glm::normalize(ray.direction)});
        }
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend));
            const auto closest = [&](const test::TestScene& scene) {
                RayQuery query(context(), scene.pack(), backend);
                return query.closest(rays);
            };
            const auto both = closest(pair.both), first = closest(pair.first);
            const auto second = closest(pair.second);
            int fromFirst = 0, fromSecond = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                const float a =
                    record::isSurface(first[i]) ? record::recordDistance(first[i]) : 3e38f;
                const float b =
                    record::isSurface(second[i]) ? record::recordDistance(second[i]) : 3e38f;
                glm::uvec4 expected = a < b ? first[i] : second[i];
                if (a >= b && record::isSurface(expected)) expected.x = 1;
                fromFirst += a < b;
                fromSecond += b < a;
                if (a == b && a < 3e38f) continue;
                ASSERT_EQ(both[i], expected) << "ray " << i << ", " << a << " and " << b;
            }
            EXPECT_GT(fromFirst, 100);
            EXPECT_GT(fromSecond, 100);
        }
    }

    static Pair meshAndField(float meshRadius, float fieldRadius, const glm::vec3& apart) {
        Pair pair;
        const std::string field = fmt::format(
            "// bounds[-{0}, -{0}, -{0}, {0}, {0}, {0}]\n"
            "float sdf(vec3 p) {{ return abs(length(p) - {1:.4f}) - 0.05; }}",
            fieldRadius + 0.1f, fieldRadius);
        pair.both.add(pair.both.addMesh(makeTorus(meshRadius, 0.3f * meshRadius)));
        pair.both.add(pair.both.addField(field)).at = apart;
        pair.first.add(pair.first.addMesh(makeTorus(meshRadius, 0.3f * meshRadius)));
        pair.second.add(pair.second.addField(field)).at = apart;
        return pair;
    }
};

TEST_F(MixedTest, MeshInsideAField) {
    expectNearerOfBoth(meshAndField(0.5f, 1.2f, {0, 0, 0}), test::seedOr(601));
}

TEST_F(MixedTest, FieldInsideAMesh) {
    Pair pair;
    const std::string field =
        "// bounds[-0.6, -0.6, -0.6, 0.6, 0.6, 0.6]\n"
        "float sdf(vec3 p) { return length(p) - 0.5; }";
    // A box without its lid, so that rays from outside get in.
    vitrine::Mesh box = makeBox(glm::vec3(1));
    box.triangles.resize(box.triangles.size() - 4);
    box.triangleParts.resize(box.triangles.size());
    pair.both.add(pair.both.addMesh(box));
    pair.both.add(pair.both.addField(field)).rotate = {10, 20, 30};
    pair.first.add(pair.first.addMesh(box));
    pair.second.add(pair.second.addField(field)).rotate = {10, 20, 30};
    expectNearerOfBoth(pair, test::seedOr(602));
}

TEST_F(MixedTest, Intersecting) {
    expectNearerOfBoth(meshAndField(1, 0.8f, {0.7f, 0.2f, 0}), test::seedOr(603));
}

TEST_F(MixedTest, SphereOfBothKindsAtOnePlace) {
    // Coincident surfaces: either answer is right, but nothing may be lost between them.
    test::TestScene scene;
    scene.add(scene.addMesh(makeSphere(1, 96)));
    scene.add(
        scene.addField("// bounds[-1.05, -1.05, -1.05, 1.05, 1.05, 1.05]\n"
                       "float sdf(vec3 p) { return length(p) - 1.0; }"));
    const uint32_t seed = test::seedOr(604);
    Random random(seed);
    std::vector<QueryRay> rays;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 from = 3.0f * glm::normalize(random.point(1) + glm::vec3(1e-4f));
        rays.push_back({from, 1e-3f, glm::normalize(random.point(0.5f) - from)});
    }
    for (const Backend backend : test::kBackends) {
        RayQuery query(context(), scene.pack(), backend);
        const auto records = query.closest(rays);
        for (size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(record::isSurface(records[i])) << "seed " << seed;
            const glm::vec3 p =
                rays[i].origin + record::recordDistance(records[i]) * rays[i].direction;
            ASSERT_NEAR(glm::length(p), 1, 1e-3) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace vitrine
