// SPDX-License-Identifier: MIT
// Rays for which sphere tracing is slow or blind: that graze a plane or a large ball at half a
// degree, and that meet a plate as thin as 1/500 of its distance. With the steps that a scene has
// by default, against the formula in double precision.
//
// A hit may lie as far off the surface as the tracer is allowed to stop before it (a twentieth of
// the cone's radius, or 4e-6 of the box), and floats lose 4e-7 of the coordinates: `shell`. So
// along the ray it may be off by shell / sine, and a ray that passes within the shell may hit or
// miss.
#include "bvh/test_meshes.hpp"
#include "gpu_support.hpp"

namespace vitrine {
namespace {

using test::Random;

/// Sine of the flattest angle at which a surface must be found: half a degree, less rounding.
constexpr double kFlattest = 0.0087;

class GrazingTest : public test::GpuTest {
  protected:
    /// What the formula says of a ray: how deep it goes below the surface (above 0: it hits), where
    /// it enters, and at what sine.
    struct Truth {
        double depth, t, sine;
    };

    template <typename Formula>
    void expectHits(const std::string& field, const std::vector<QueryRay>& rays, double shell,
                    const Formula& formula) {
        test::TestScene scene;
        scene.add(scene.addField(field));
        const PackedScene packed = scene.pack();
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend));
            RayQuery query(context(), packed, backend);
            const auto records = query.closest(rays);
            int hits = 0, holes = 0, ghosts = 0, off = 0;
            double worst = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                const Truth truth = formula(rays[i]);
                if (truth.depth > 0 && truth.sine < kFlattest) continue;
                const bool hit = record::isSurface(records[i]);
                holes += !hit && truth.depth > shell ? 1 : 0;
                ghosts += hit && truth.depth < -shell ? 1 : 0;
                if (!hit || truth.depth < shell) continue;
                ++hits;
                const double error =
                    std::abs(record::recordDistance(records[i]) - truth.t) * truth.sine / shell;
                worst = std::max(worst, error);
                off += error > 1 ? 1 : 0;
            }
            fmt::print(
                "{} rays, {} hits; {} holes, {} ghosts; off by at most {:.2f} of what is "
                "allowed\n",
                rays.size(), hits, holes, ghosts, worst);
            EXPECT_GT(hits, static_cast<int>(rays.size()) / 3);
            EXPECT_EQ(holes, 0);
            EXPECT_EQ(ghosts, 0);
            EXPECT_EQ(off, 0);
        }
    }
};

double shellOf(double boxSize, double radius) {
    return 4e-6 * boxSize + 0.055 * radius + 4e-7 * boxSize;
}

struct BoxEntry {
    bool hit;
    double t, sine;

    BoxEntry(const QueryRay& ray, const glm::dvec3& half) {
        const glm::dvec3 o(ray.origin), d(ray.direction);
        const glm::dvec3 a = (-half - o) / d, b = (half - o) / d;
        const glm::dvec3 low = glm::min(a, b), high = glm::max(a, b);
        t = std::max({low.x, low.y, low.z});
        hit = std::min({half.x, half.y, half.z}) > 0 && t < std::min({high.x, high.y, high.z});
        sine = std::abs(d[t == low.x ? 0 : t == low.y ? 1 : 2]);
    }
};

/// By how much the box could shrink on all sides and still be hit; below 0, would have to grow.
double depthInBox(const QueryRay& ray, const glm::dvec3& half) {
    double low = -0.5, high = 0.5;
    for (int i = 0; i < 50; ++i) {
        const double shrink = 0.5 * (low + high);
        (BoxEntry(ray, half - shrink).hit ? low : high) = shrink;
    }
    return low;
}

TEST_F(GrazingTest, APlane) {
    // From a man's height the ground at half a degree is 180 m away.
    for (const float radius : {0.0f, 0.05f}) {
        Random random(test::seedOr(501));
        std::vector<QueryRay> rays;
        for (int i = 0; i < 4000; ++i) {
            const float angle = glm::radians(i % 2 ? 0.5f : random.uniform(0.5f, 6.0f));
            const float turn = random.uniform(0, 6.28f), height = random.uniform(0.2f, 1.6f);
            rays.push_back({{0, height, 0},
                            radius,
                            {std::cos(angle) * std::cos(turn), -std::sin(angle),
                             std::cos(angle) * std::sin(turn)}});
        }
        expectHits("// bounds[-200, -1, -200,  200, 3, 200]\nfloat sdf(vec3 p) { return p.y; }\n",
                   rays, shellOf(400, radius), [](const QueryRay& ray) {
                       const double sine = -ray.direction.y;
                       return Truth{1, ray.origin.y / sine, sine};
                   });
    }
}

TEST_F(GrazingTest, ALargeBall) {
    // 50 m; met at half a degree, 2 mm below its outline.
    for (const float radius : {0.0f, 0.005f}) {
        Random random(test::seedOr(502));
        std::vector<QueryRay> rays;
        while (rays.size() < 4000) {
            const float angle = glm::radians(rays.size() % 2 ? 0.5f : random.uniform(-6.0f, 6.0f));
            const glm::vec3 n = glm::normalize(random.point(1) + glm::vec3(1e-4f));
            const glm::vec3 along = test::frameOf(n)[0];
            const float passes = 50 * (angle < 0 ? 2 - std::cos(angle) : std::cos(angle));
            rays.push_back({passes * n - 60.0f * along, radius, along});
        }
        expectHits(
            "// bounds[-51, -51, -51,  51, 51, 51]\n"
            "float sdf(vec3 p) { return length(p) - 50.0; }\n",
            rays, shellOf(102, radius), [](const QueryRay& ray) {
                const glm::dvec3 o(ray.origin), d(ray.direction);
                const double nearest = -glm::dot(o, d) / glm::dot(d, d);
                const double miss = glm::length(o + nearest * d);
                const double half = std::sqrt(std::max(0.0, 2500 - miss * miss));
                return Truth{50 - miss, nearest - half, half / 50};
            });
    }
}

TEST_F(GrazingTest, AThinPlate) {
    // One hundredth of a metre from five metres away; half of the rays come within a degree of its
    // own plane, where nothing but its edge is seen.
    constexpr double kHalf = 0.005;
    const glm::dvec3 half(0.5, kHalf, 0.5);
    for (const float radius : {0.001f, 0.009f}) {
        Random random(test::seedOr(503));
        std::vector<QueryRay> rays;
        for (int i = 0; i < 6000; ++i) {
            const float rise =
                glm::radians(i % 2 ? random.uniform(-1, 1) : random.uniform(-90, 90));
            const float turn = random.uniform(0, 6.28f);
            const glm::vec3 eye = 5.0f * glm::vec3(std::cos(rise) * std::cos(turn), std::sin(rise),
                                                   std::cos(rise) * std::sin(turn));
            const glm::vec3 aim =
                1.1f * glm::vec3(half) *
                glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            rays.push_back({eye, radius, glm::normalize(aim - eye)});
        }
        expectHits(
            "// bounds[-0.6, -0.1, -0.6,  0.6, 0.1, 0.6]\n"
            "float sdf(vec3 p) { return sdBox(p, vec3(0.5, 0.005, 0.5)); }\n",
            rays, shellOf(1.2, radius) + 4e-7 * 5, [&](const QueryRay& ray) {
                return Truth{depthInBox(ray, half), BoxEntry(ray, half).t,
                             BoxEntry(ray, half).sine};
            });
    }
}

}  // namespace
}  // namespace vitrine
