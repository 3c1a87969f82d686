// SPDX-License-Identifier: MIT
// Rays that leave a convex body never meet it again (no acne), and rays that enter it always do (no
// light leaks through). Origins are lifted as shade/surface.glsl lifts them. No tolerance: not one
// ray of any angle may be wrong.
#include "bvh/test_meshes.hpp"
#include "gpu_support.hpp"
#include "gpu_trace_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

using test::Random;

struct Body {
    std::string name;
    test::TestScene scene;
    vitrine::Mesh mesh;  // empty: a field
    /// Of a field: from a point of the surface to the outward normal there.
    glm::dvec3 (*fieldNormal)(const glm::dvec3& p) = nullptr;

    [[nodiscard]] bool field() const { return fieldNormal != nullptr; }
    /// Object space. Of a mesh: across the triangle that was hit.
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& p, uint32_t primitive) const {
        if (field()) return fieldNormal(p);
        const glm::uvec3 t = mesh.triangles[primitive];
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        return glm::normalize(glm::cross(b - a, c - a));
    }
};

glm::dvec3 sphereNormal(const glm::dvec3& p) {
    return glm::normalize(p);
}

glm::dvec3 boxNormal(const glm::dvec3& p) {
    const glm::dvec3 a = glm::abs(p);
    const int axis = a.x > a.y && a.x > a.z ? 0 : a.y > a.z ? 1 : 2;
    glm::dvec3 n(0);
    n[axis] = p[axis] > 0 ? 1 : -1;
    return n;
}

class LeaveTest : public test::GpuTest {
  protected:
    /// The rays that hit `body` from around it.
    static std::vector<QueryRay> looks(const glm::mat4& m, Random& random, float radius,
                                       int count) {
        std::vector<QueryRay> rays;
        for (int i = 0; i < count; ++i) {
            const glm::vec3 eye = 4.0f * glm::normalize(random.point(1) + glm::vec3(1e-4f));
            const glm::vec3 aim = random.point(0.55f);
            rays.push_back({glm::vec3(m * glm::vec4(eye, 1)), radius, {}});
            rays.back().direction =
                glm::normalize(glm::vec3(m * glm::vec4(aim, 1)) - rays.back().origin);
        }
        return rays;
    }

    void expectCleanLeave(const Body& body, uint32_t seed, float radius) {
        SCOPED_TRACE(body.name + ", seed " + std::to_string(seed) + ", cone " +
                     std::to_string(radius));
        const PackedScene packed = body.scene.pack();
        const glm::mat4 m = packed.instances[0].worldFromObject;
        const glm::dmat4 inverse = glm::inverse(glm::dmat4(m));
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend));
            Random random(seed);
            RayQuery query(context(), packed, backend);
            const auto rays = looks(m, random, radius, 4000);
            const auto records = query.closest(rays);
            std::vector<QueryRay> out, in;
            for (size_t i = 0; i < rays.size(); ++i) {
                if (!record::isSurface(records[i])) continue;
                const float t = record::recordDistance(records[i]);
                const glm::vec3 p = rays[i].origin + t * rays[i].direction;
                const glm::dvec3 local(inverse * glm::dvec4(p, 1));
                const glm::vec3 n(glm::normalize(glm::transpose(glm::dmat3(inverse)) *
                                                 body.normal(local, records[i].y)));
                const glm::vec3 a = glm::abs(p);
                float lift = 1e-5f * (std::max({a.x, a.y, a.z}) + t);
                if (body.field()) {
                    const float scale = glm::length(glm::mat3(m) * glm::vec3(0.57735027f));
                    lift += 0.35f * radius + 2.0f * 4e-6f * 1.05f * scale;
                }
                const glm::vec3 from = p + lift * n;
                const auto [side, other] = test::frameOf(n);
                const float around = random.uniform(0, 2 * kPi);
                const glm::vec3 along = std::cos(around) * side + std::sin(around) * other;
                // Half of them graze the surface.
                const float rise = random.integer(0, 1) ? random.uniform(0, 1)
                                                        : std::pow(10.0f, random.uniform(-5, -1));
                const float run = std::sqrt(1 - rise * rise);
                out.push_back({from, radius, glm::normalize(rise * n + run * along)});
                const glm::vec3 inside = glm::vec3(m * glm::vec4(random.point(0.5f), 1));
                in.push_back({from, radius, glm::normalize(inside - from)});
            }
            EXPECT_GT(out.size(), 2000u);
            EXPECT_EQ(count(query.any(out), true), 0) << "rays meet the body that they leave";
            EXPECT_EQ(count(query.any(in), false), 0) << "rays pass the body that they enter";
        }
    }

  private:
    static int count(const std::vector<glm::uvec4>& records, bool hit) {
        int n = 0;
        for (const glm::uvec4& r : records) n += record::isSurface(r) == hit;
        return n;
    }
};

std::vector<Body> bodies() {
    std::vector<Body> list(4);
    list[0] = {"field of a sphere", {}, {}, sphereNormal};
    list[0].scene.addField(
        "// bounds[-1.05, -1.05, -1.05, 1.05, 1.05, 1.05]\n"
        "float sdf(vec3 p) { return length(p) - 1.0; }");
    list[1] = {"field of a box", {}, {}, boxNormal};
    list[1].scene.addField(
        "// bounds[-1.05, -1.05, -1.05, 1.05, 1.05, 1.05]\n"
        "float sdf(vec3 p) { vec3 q = abs(p) - vec3(1.0);\n"
        "return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0); }");
    list[2] = {"mesh of a sphere", {}, makeSphere(1)};
    list[2].scene.addMesh(list[2].mesh);
    list[3] = {"mesh of a box", {}, makeBox(glm::vec3(1))};
    list[3].scene.addMesh(list[3].mesh);
    for (Body& body : list) body.scene.add(0);
    return list;
}

void place(Body& body, const glm::vec3& at, const glm::vec3& rotate, const glm::vec3& scale) {
    Node& node = body.scene.scene.nodes[0];
    node.at = at;
    node.rotate = rotate;
    node.scale = scale;
}

TEST_F(LeaveTest, AtRest) {
    for (const Body& body : bodies())
        for (const float radius : {0.0f, 1e-3f, 1e-2f})
            expectCleanLeave(body, test::seedOr(501), radius);
}

TEST_F(LeaveTest, OfAnySize) {
    for (const float scale : {0.01f, 100.0f})
        for (Body& body : bodies()) {
            place(body, scale * glm::vec3(3, -2, 1), {20, 70, -50}, glm::vec3(scale));
            expectCleanLeave(body, test::seedOr(502), 0);
            expectCleanLeave(body, test::seedOr(503), 1e-3f * scale);
        }
}

TEST_F(LeaveTest, FarFromTheOrigin) {
    for (Body& body : bodies()) {
        place(body, {1000, -2000, 500}, {20, 70, -50}, glm::vec3(1));
        expectCleanLeave(body, test::seedOr(504), 1e-3f);
    }
}

TEST_F(LeaveTest, Squeezed) {
    for (const glm::vec3& scale : {glm::vec3(1, 0.1f, 1), glm::vec3(0.1f, 2, -0.5f)})
        for (Body& body : bodies()) {
            place(body, {3, -2, 1}, {20, 70, -50}, scale);
            expectCleanLeave(body, test::seedOr(505), 0);
            expectCleanLeave(body, test::seedOr(506), 1e-3f);
        }
}

}  // namespace
}  // namespace vitrine
