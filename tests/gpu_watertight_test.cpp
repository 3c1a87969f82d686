// SPDX-License-Identifier: MIT
// Closed meshes do not leak: a ray that meets the surface well inside of its outline hits it, even
// exactly through corners and along edges, from near and from far, and through transforms.
// No tolerance: not one ray may pass.
#include "bvh/test_meshes.hpp"
#include "gpu_support.hpp"
#include "gpu_trace_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

using test::Random;

class WatertightTest : public test::GpuTest {
  protected:
    void expectHits(const PackedScene& packed, const std::vector<QueryRay>& rays) {
        for (const Backend backend : test::kBackends) {
            SCOPED_TRACE(test::nameOf(backend));
            RayQuery query(context(), packed, backend);
            const auto closest = query.closest(rays);
            const auto any = query.any(rays);
            int leaks = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                const bool leak = !record::isSurface(closest[i]) || !record::isSurface(any[i]);
                if (leak && ++leaks <= 3)
                    ADD_FAILURE() << "ray " << i << ": "
                                  << test::textOf({rays[i].origin, rays[i].direction});
            }
            EXPECT_EQ(leaks, 0) << "of " << rays.size() << " rays";
        }
    }
};

/// A corner, a point on an edge, or any point of a random triangle.
glm::vec3 aimAt(const test::Mesh& mesh, Random& random) {
    const glm::uvec3 t = mesh.triangles[static_cast<size_t>(
        random.integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
    const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    switch (random.integer(0, 3)) {
        case 0:
            return a;
        case 1:
            return glm::mix(a, b, random.uniform(0, 1));
        case 2:
            return 0.5f * (b + c);
        default: {
            const float u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
            return a + u * (b - a) + v * (c - a);
        }
    }
}

QueryRay towards(const glm::vec3& from, const glm::vec3& aim) {
    return {from, 0, glm::normalize(aim - from)};
}

TEST_F(WatertightTest, FromInsideASphere) {
    struct Place {
        glm::vec3 centre;
        float radius;
    };
    const uint32_t seed = test::seedOr(201);
    for (const Place& place : {Place{{}, 1}, Place{{}, 1e-6f}, Place{{}, 1e6f},
                               Place{{1e4f, -1e4f, 1e4f}, 1}, Place{{1e6f, 1e6f, -1e6f}, 10}}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " + std::to_string(place.radius));
        Random random(seed);
        const test::Mesh mesh = test::sphere(40, 60, place.radius, place.centre);
        test::TestScene scene;
        scene.add(scene.addMesh(mesh.positions, mesh.triangles));
        std::vector<QueryRay> rays;
        while (rays.size() < 20000) {
            const glm::vec3 from = place.centre + random.point(0.5f * place.radius);
            rays.push_back(towards(from, aimAt(mesh, random)));
        }
        for (int axis = 0; axis < 3; ++axis)
            for (const float sign : {-1.0f, 1.0f}) {
                glm::vec3 direction(0);
                direction[axis] = sign;
                rays.push_back({place.centre, 0, direction});
            }
        expectHits(scene.pack(), rays);
    }
}

TEST_F(WatertightTest, FromAfar) {
    const uint32_t seed = test::seedOr(202);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const test::Mesh mesh = test::sphere(60, 90, 1, {});
    test::TestScene scene;
    scene.add(scene.addMesh(mesh.positions, mesh.triangles));
    std::vector<QueryRay> rays;
    while (rays.size() < 60000) {
        const glm::vec3 aim = aimAt(mesh, random);
        const float distance = std::pow(10.0f, random.uniform(0.3f, 4));
        const glm::vec3 from = distance * glm::normalize(aim + random.point(0.5f));
        // Well inside of the outline, by more than the rounding of such a distance.
        if (glm::dot(glm::normalize(aim), glm::normalize(from - aim)) < 0.2f) continue;
        rays.push_back(towards(from, aim));
    }
    expectHits(scene.pack(), rays);
}

/// The six faces of a cube, each a grid in exact coordinates: all edges lie in planes of boxes.
test::Mesh gridCube(int cells, float half) {
    test::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-half, half})
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    const auto corner = [&](int u, int v) {
                        glm::vec3 p;
                        p[axis] = side;
                        p[(axis + 1) % 3] =
                            half * (2 * static_cast<float>(u) / static_cast<float>(cells) - 1);
                        p[(axis + 2) % 3] =
                            half * (2 * static_cast<float>(v) / static_cast<float>(cells) - 1);
                        return p;
                    };
                    mesh.add(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
                    mesh.add(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
                }
    return mesh;
}

TEST_F(WatertightTest, AlongTheEdgesOfAGrid) {
    const uint32_t seed = test::seedOr(203);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const test::Mesh mesh = gridCube(16, 1);
    test::TestScene scene;
    scene.add(scene.addMesh(mesh.positions, mesh.triangles));
    std::vector<QueryRay> rays;
    while (rays.size() < 200000) {
        // From in front of a face and far, nearly or exactly across it, at corners and edges.
        const int axis = random.integer(0, 2);
        const int x = (axis + 1) % 3, y = (axis + 2) % 3;
        glm::vec3 aim, from;
        aim[axis] = random.integer(0, 1) ? 1.0f : -1.0f;
        aim[x] = static_cast<float>(random.integer(-7, 7)) / 8;
        aim[y] = random.integer(0, 1) ? static_cast<float>(random.integer(-7, 7)) / 8
                                      : random.uniform(-0.9f, 0.9f);
        const float distance = std::pow(10.0f, random.uniform(0.5f, 4));
        from = aim;
        from[axis] *= distance;
        const float tilt = random.integer(0, 1) ? 0.0f : std::pow(10.0f, random.uniform(-9, -1));
        from[x] += tilt * distance * random.uniform(-1, 1);
        from[y] += tilt * distance * random.uniform(-1, 1);
        rays.push_back(towards(from, aim));
    }
    expectHits(scene.pack(), rays);
}

TEST_F(WatertightTest, ThroughTransforms) {
    const uint32_t seed = test::seedOr(204);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const test::Mesh mesh = test::sphere(30, 40, 1, {});
    const test::Mesh cube = gridCube(4, 1);
    for (int i = 0; i < 12; ++i) {
        test::TestScene scene;
        const bool round = i % 2 == 0;
        const test::Mesh& shape = round ? mesh : cube;
        Node& node = scene.add(scene.addMesh(shape.positions, shape.triangles));
        node.at = random.point(10);
        node.rotate = i % 3 == 0 ? glm::vec3(0, 90, 0) : random.point(180);
        for (int axis = 0; axis < 3; ++axis)
            node.scale[axis] = std::pow(10.0f, random.uniform(-1.5f, 1.5f)) *
                               (random.integer(0, 1) ? -1.0f : 1.0f);
        const PackedScene packed = scene.pack();
        const glm::mat4 m = packed.instances[0].worldFromObject;
        std::vector<QueryRay> rays;
        while (rays.size() < 6000) {
            const glm::vec3 from = glm::vec3(m * glm::vec4(random.point(0.5f), 1));
            const glm::vec3 aim = glm::vec3(m * glm::vec4(aimAt(shape, random), 1));
            rays.push_back(towards(from, aim));
        }
        expectHits(packed, rays);
    }
}

TEST_F(WatertightTest, BuiltInShapes) {
    const uint32_t seed = test::seedOr(205);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const vitrine::Mesh& mesh :
         {makeBox(glm::vec3(1, 0.3f, 2)), makeSphere(1), makeCylinder(1, 0.5f)}) {
        test::TestScene scene;
        scene.add(scene.addMesh(mesh));
        std::vector<QueryRay> rays;
        for (const glm::vec3& direction : test::randomDirections(random, 20000))
            rays.push_back({glm::vec3(0.01f, 0.02f, -0.03f), 0, direction});
        for (const glm::vec3& corner : mesh.positions)
            rays.push_back(towards(glm::vec3(0), corner));
        SCOPED_TRACE(mesh.name);
        expectHits(scene.pack(), rays);
    }
}

}  // namespace
}  // namespace vitrine
