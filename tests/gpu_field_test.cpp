// SPDX-License-Identifier: MIT
// A distance field of a sphere against the sphere on paper, from 0.1 to 1000 m away, of 0.01 to 100
// m, rotated and squeezed to ellipsoids; and against a fine mesh of it.
//
// Tolerances, in units of the object, whose radius is 1 and whose box is 1.05 large:
// - the hit lies within a shell around the surface: marching stops at 4e-6 of the box (see
//   pack_scene.cpp) or at 0.2 of the radius of the ray's cone, and floats lose 4e-7 of the
//   distances to the ray's origin and to that of the world;
// - the distance along the ray differs from the true one by no more than that shell allows at this
//   angle: shell / sine, where a shell's outline is met at no less than sqrt(2 shell);
// - the normal is off by at most 0.1 degrees, and by what the shell is in radians;
// - rays that pass the sphere outside of the shell miss, rays that enter it hit.
#include "bvh/test_meshes.hpp"
#include "gpu_support.hpp"
#include "gpu_trace_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

using test::Random;

constexpr double kFinest = 8e-6;
constexpr double kRounding = 4e-7;
constexpr float kPixel = 1e-3f;  // of the object: a rather close look, at 1000 pixels a radius
constexpr const char* kSphere =
    "// bounds[-1.05, -1.05, -1.05, 1.05, 1.05, 1.05]\n"
    "float sdf(vec3 p) { return length(p) - 1.0; }";

/// A ray and the unit sphere under a transform, in double precision.
struct Truth {
    glm::dvec3 origin, direction;  // object space; t means the same as in the world
    double miss;                   // least distance of the line from the centre
    double nearest;                // t of that
    glm::dmat3 objectFromWorld;
    double shell;  // what is allowed to lie between the surface and a hit

    Truth(const glm::mat4& worldFromObject, const QueryRay& ray) {
        const glm::dmat4 inverse = glm::inverse(glm::dmat4(worldFromObject));
        objectFromWorld = glm::dmat3(inverse);
        origin = glm::dvec3(inverse * glm::dvec4(ray.origin, 1));
        direction = objectFromWorld * glm::dvec3(ray.direction);
        nearest = -glm::dot(origin, direction) / glm::dot(direction, direction);
        miss = glm::length(origin + nearest * direction);
        double largest = 0;  // how long a unit of the world can be in the object
        for (int i = 0; i < 3; ++i)
            largest = std::max(largest, 1 / glm::length(glm::dvec3(worldFromObject[i])));
        shell = kFinest + 0.21 * ray.radius * largest +
                kRounding * (glm::length(origin) + glm::length(glm::dvec3(inverse[3])) + 1);
    }
    [[nodiscard]] double enter(double radius) const {
        return nearest - std::sqrt(std::max(0.0, radius * radius - miss * miss)) / speed();
    }
    [[nodiscard]] double speed() const { return glm::length(direction); }
};

class FieldTest : public test::GpuTest {
  protected:
    static PackedScene sphereScene(const glm::vec3& at, const glm::vec3& rotate,
                                   const glm::vec3& scale, int marchSteps = 2048) {
        test::TestScene scene;
        scene.scene.render.marchSteps = marchSteps;
        Node& node = scene.add(scene.addField(kSphere));
        node.at = at;
        node.rotate = rotate;
        node.scale = scale;
        return scene.pack();
    }

    /// Rays at points of the sphere and just inside and outside of its outline, from `distance`
    /// object radii (along each axis of the ellipsoid) away from the surface. A ray without a
    /// radius needs more than the usual 256 steps to graze the surface.
    static std::vector<QueryRay> raysAt(const glm::mat4& m, Random& random, float distance,
                                        int count, float radius = 0) {
        std::vector<QueryRay> rays;
        while (static_cast<int>(rays.size()) < count) {
            const glm::vec3 toEye = glm::normalize(random.point(1) + glm::vec3(1e-4f));
            const glm::vec3 side = test::frameOf(toEye)[0];
            const float graze = std::pow(10.0f, random.uniform(-6, 0));
            const float height = random.integer(0, 1) ? random.uniform(0, 1)
                                                      : 1 + (random.integer(0, 1) ? graze : -graze);
            const glm::vec3 eye = toEye * (1 + distance);
            rays.push_back({glm::vec3(m * glm::vec4(eye + 0.3f * height * side, 1)), radius, {}});
            const glm::vec3 aim = glm::vec3(m * glm::vec4(height * side, 1));
            rays.back().direction = glm::normalize(aim - rays.back().origin);
        }
        return rays;
    }

    void expectSphere(const PackedScene& packed, const std::vector<QueryRay>& rays,
                      bool mayMiss = false) {
        const glm::mat4 m = packed.instances[0].worldFromObject;
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend));
            RayQuery query(context(), packed, backend);
            const auto records = query.closest(rays);
            const auto any = query.any(rays);
            int wrong = 0, hits = 0;
            double worstAngle = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                const Truth truth(m, rays[i]);
                const bool hit = record::isSurface(records[i]);
                hits += hit;
                if (mayMiss && !hit) continue;
                const std::string problem = problemOf(truth, records[i], worstAngle);
                if (!problem.empty() && ++wrong <= 3)
                    ADD_FAILURE() << problem << ", ray " << i << " at " << truth.miss;
                EXPECT_EQ(hit, record::isSurface(any[i]));
            }
            EXPECT_EQ(wrong, 0) << "of " << rays.size();
            EXPECT_GT(hits, static_cast<int>(rays.size()) / 3);
            largestAngle_ = std::max(largestAngle_, worstAngle);
        }
    }

    double largestAngle_ = 0;  // degrees, beyond what the shell explains

  private:
    static std::string problemOf(const Truth& truth, const glm::uvec4& record, double& worstAngle) {
        const double shell = truth.shell;
        if (!record::isSurface(record))
            return truth.miss < 1 - shell && truth.enter(1) > 0 ? "a hole" : "";
        if (truth.miss > 1 + shell) return "a hit beside the sphere";
        const double t = record::recordDistance(record);
        const double radius = glm::length(truth.origin + t * truth.direction);
        if (std::abs(radius - 1) > shell)
            return fmt::format("{} off the surface, {} allowed", radius - 1, shell);
        // The sine at which the line meets the sphere.
        const double sine = std::sqrt(std::max(2 * shell, 1 - truth.miss * truth.miss));
        const double depth = std::abs(t - truth.enter(1)) * truth.speed();
        if (depth > 2.5 * shell / sine)
            return fmt::format("{} off in depth, {} allowed", depth, 2.5 * shell / sine);
        const glm::dvec3 p = truth.origin + t * truth.direction;
        const glm::dvec3 normal = glm::normalize(glm::transpose(truth.objectFromWorld) * p);
        const glm::dvec3 found(record::unpackNormal(record.z));
        const double angle =
            std::atan2(glm::length(glm::cross(normal, found)), glm::dot(normal, found));
        // A squeezed sphere turns an angle by up to its aspect.
        const double excess = glm::degrees(std::max(0.0, angle - 2 * shell * aspect(truth)));
        worstAngle = std::max(worstAngle, excess);
        if (excess > 0.1 * aspect(truth)) return fmt::format("normal off by {} degrees", excess);
        return "";
    }

    static double aspect(const Truth& truth) {
        double least = 1e300, most = 0;
        for (int i = 0; i < 3; ++i) {
            const glm::dmat3 rows = glm::transpose(truth.objectFromWorld);
            least = std::min(least, glm::length(rows[i]));
            most = std::max(most, glm::length(rows[i]));
        }
        return most / least;
    }
};

TEST_F(FieldTest, SphereOfAnySizeFromAnyDistance) {
    const uint32_t seed = test::seedOr(401);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (const float scale : {0.01f, 1.0f, 100.0f})
        for (const float distance : {0.1f, 3.0f, 1000.0f}) {
            SCOPED_TRACE(fmt::format("scale {}, distance {}", scale, distance));
            const PackedScene packed =
                sphereScene(scale * random.point(2), random.point(180), glm::vec3(scale));
            expectSphere(packed, raysAt(packed.instances[0].worldFromObject, random,
                                        distance / scale, 4000));
        }
    RecordProperty("largest_normal_error_degrees", std::to_string(largestAngle_));
}

TEST_F(FieldTest, RaysOfPixelsNeedFewSteps) {
    const uint32_t seed = test::seedOr(406);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (const glm::vec3& scale : {glm::vec3(1), glm::vec3(0.01f), glm::vec3(2, 0.5f, 1)}) {
        const PackedScene packed = sphereScene(random.point(5), random.point(180), scale, 256);
        const glm::mat4 m = packed.instances[0].worldFromObject;
        const float pixel = kPixel * std::max({scale.x, scale.y, scale.z});
        expectSphere(packed, raysAt(m, random, 3, 8000, pixel));
    }
}

TEST_F(FieldTest, TheLastStepStillGivesANormal) {
    // So few steps that many rays end on the way; what was hit has a normal all the same.
    const uint32_t seed = test::seedOr(407);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const PackedScene packed = sphereScene(glm::vec3(0), glm::vec3(0), glm::vec3(1), 12);
    expectSphere(packed, raysAt(glm::mat4(1), random, 3, 8000, kPixel), true);
}

TEST_F(FieldTest, Ellipsoids) {
    const uint32_t seed = test::seedOr(402);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (const glm::vec3& scale :
         {glm::vec3(1, 0.1f, 1), glm::vec3(3, 1, 0.5f), glm::vec3(-1, 2, 1),
          glm::vec3(0.05f, 0.2f, 0.05f), glm::vec3(20, 40, -80)}) {
        SCOPED_TRACE(fmt::format("scale {} {} {}", scale.x, scale.y, scale.z));
        const PackedScene packed = sphereScene(random.point(5), random.point(180), scale);
        expectSphere(packed, raysAt(packed.instances[0].worldFromObject, random, 5, 4000));
    }
}

TEST_F(FieldTest, EyeInsideTheBox) {
    const uint32_t seed = test::seedOr(403);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const PackedScene packed = sphereScene(random.point(5), random.point(180), glm::vec3(1));
    expectSphere(packed, raysAt(packed.instances[0].worldFromObject, random, 0.02f, 8000));
}

TEST_F(FieldTest, LooksLikeAFineMesh) {
    // The mesh lies inside the sphere, by at most this part of its radius (the sagitta of an edge,
    // 1 - cos(pi / 256), in both directions).
    constexpr double kSagitta = 2 * 7.6e-5;
    const uint32_t seed = test::seedOr(404);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    test::TestScene meshScene;
    meshScene.add(meshScene.addMesh(makeSphere(1, 256)));
    const PackedScene field = sphereScene(glm::vec3(0), glm::vec3(0), glm::vec3(1));
    const std::vector<QueryRay> rays = raysAt(glm::mat4(1), random, 3, 20000);
    for (const Backend backend : test::kBackends) {
        RayQuery fieldQuery(context(), field, backend),
            meshQuery(context(), meshScene.pack(), backend);
        const auto a = fieldQuery.closest(rays);
        const auto b = meshQuery.closest(rays);
        int both = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const Truth truth(glm::mat4(1), rays[i]);
            const double height = truth.miss;
            if (height < 1 - kSagitta || height > 1 + truth.shell) {
                ASSERT_EQ(record::isSurface(a[i]), record::isSurface(b[i])) << "at " << height;
            }
            if (!record::isSurface(a[i]) || !record::isSurface(b[i])) continue;
            ++both;
            const double sine = std::sqrt(std::max(1 - height * height, 2 * kSagitta));
            ASSERT_NEAR(record::recordDistance(a[i]), record::recordDistance(b[i]),
                        2 * (kSagitta + truth.shell) / sine);
        }
        EXPECT_GT(both, 10000);
    }
}

TEST_F(FieldTest, NotANumberIsAMiss) {
    test::TestScene scene;
    scene.add(
        scene.addField("// bounds[-1, -1, -1, 1, 1, 1]\n"
                       "float sdf(vec3 p) { return sqrt(-1.0 - p.x * p.x); }"));
    for (const Backend backend : test::kBackends) {
        RayQuery query(context(), scene.pack(), backend);
        const std::vector<QueryRay> rays(4, {{0.1f, 0, 5}, 0, {0, 0, -1}});
        EXPECT_FALSE(record::isSurface(query.closest(rays)[0]));
    }
}

TEST_F(FieldTest, PromisedSlopeIsUsed) {
    // Twice the true distance: steps must be halved, or rays jump through the shell.
    test::TestScene scene;
    scene.add(
        scene.addField("// bounds[-1.1, -1.1, -1.1, 1.1, 1.1, 1.1]\n// lipschitz[4]\n"
                       "float sdf(vec3 p) { return 4.0 * (abs(length(p) - 1.0) - 0.01); }"));
    const uint32_t seed = test::seedOr(405);
    Random random(seed);
    const PackedScene packed = scene.pack();
    const std::vector<QueryRay> rays = raysAt(glm::mat4(1), random, 2, 4000);
    for (const Backend backend : test::kBackends) {
        RayQuery query(context(), packed, backend);
        const auto records = query.closest(rays);
        for (size_t i = 0; i < rays.size(); ++i) {
            const Truth truth(glm::mat4(1), rays[i]);
            if (truth.miss > 1) continue;
            ASSERT_TRUE(record::isSurface(records[i])) << "seed " << seed << ", at " << truth.miss;
            ASSERT_NEAR(record::recordDistance(records[i]), truth.enter(1.01), 1e-3) << truth.miss;
        }
    }
}

}  // namespace
}  // namespace vitrine
