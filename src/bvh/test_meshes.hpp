// SPDX-License-Identifier: MIT
// Meshes and rays for the tests of this folder, friendly and hostile.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "base/aabb.hpp"
#include "bvh/triangle.hpp"

namespace vitrine::test {

struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        const auto first = uint32_t(positions.size());
        positions.insert(positions.end(), {a, b, c});
        triangles.push_back({first, first + 1, first + 2});
    }
    [[nodiscard]] std::vector<Aabb> boxes() const {
        std::vector<Aabb> result(triangles.size());
        for (size_t i = 0; i < triangles.size(); ++i)
            for (int corner = 0; corner < 3; ++corner)
                result[i].grow(positions[triangles[i][corner]]);
        return result;
    }
};

class Random {
  public:
    explicit Random(uint32_t seed) : engine_(seed) {}
    float uniform(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(engine_);
    }
    int integer(int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(engine_);
    }
    glm::vec3 point(float radius) {
        return {uniform(-radius, radius), uniform(-radius, radius), uniform(-radius, radius)};
    }

  private:
    std::mt19937 engine_;
};

/// Triangles of one size anywhere in a cube.
inline Mesh soup(Random& random, int count, float radius, float size) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at = random.point(radius);
        mesh.add(at + random.point(size), at + random.point(size), at + random.point(size));
    }
    return mesh;
}

/// Slivers, points, duplicates, triangles in axis planes, at whole coordinates: much is equal.
inline Mesh hostileSoup(Random& random, int count, float scale) {
    Mesh mesh;
    const auto grid = [&] {
        return glm::vec3(random.integer(-4, 4), random.integer(-4, 4), random.integer(-4, 4));
    };
    while (int(mesh.triangles.size()) < count) {
        glm::vec3 a = grid();
        glm::vec3 b = grid();
        glm::vec3 c = grid();
        switch (random.integer(0, 5)) {
            case 0:
                c = a + (b - a) * 0.5f + random.point(1e-5f);
                break;  // sliver
            case 1:
                b = c = a;
                break;  // point
            case 2:
                c = b;
                break;  // line
            case 3:
                a.y = b.y = c.y = float(random.integer(-2, 2));
                break;  // flat
            case 4:
                mesh.add(a * scale, b * scale, c * scale);
                break;  // twice
            default:
                break;
        }
        mesh.add(a * scale, b * scale, c * scale);
    }
    return mesh;
}

/// A closed sphere with poles; neighbours share corners.
inline Mesh sphere(int rings, int sides, float radius, const glm::vec3& centre) {
    Mesh mesh;
    mesh.positions.push_back(centre + glm::vec3(0, radius, 0));
    for (int ring = 1; ring < rings; ++ring) {
        const float polar = kPi * float(ring) / float(rings);
        for (int side = 0; side < sides; ++side) {
            const float around = 2 * kPi * float(side) / float(sides);
            mesh.positions.push_back(
                centre + radius * glm::vec3(std::sin(polar) * std::cos(around), std::cos(polar),
                                            std::sin(polar) * std::sin(around)));
        }
    }
    mesh.positions.push_back(centre - glm::vec3(0, radius, 0));
    const auto last = uint32_t(mesh.positions.size() - 1);
    const auto corner = [&](int ring, int side) {
        if (ring == 0) return 0u;
        if (ring == rings) return last;
        return uint32_t(1 + (ring - 1) * sides + side % sides);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const uint32_t a = corner(ring, side), b = corner(ring, side + 1);
            const uint32_t c = corner(ring + 1, side), d = corner(ring + 1, side + 1);
            if (ring > 0) mesh.triangles.push_back({a, b, c});
            if (ring < rings - 1) mesh.triangles.push_back({b, d, c});
        }
    }
    return mesh;
}

/// Between two points of a cube around the scene.
inline Ray ray(Random& random, float radius) {
    Ray result{random.point(radius), {}};
    do result.direction = random.point(radius) - result.origin;
    while (result.direction == glm::vec3(0));
    return result;
}

/// Along an axis or in an axis plane, through whole coordinates times `scale`, with zeros of
/// either sign: the slabs are full of infinities and NaNs.
inline Ray axisRay(Random& random, float scale) {
    Ray result{
        glm::vec3(random.integer(-5, 5), random.integer(-5, 5), random.integer(-5, 5)) * scale,
        glm::vec3(random.integer(0, 1) ? 0.0f : -0.0f)};
    result.direction[random.integer(0, 2)] = random.integer(0, 1) ? scale : -scale;
    if (random.integer(0, 1)) result.direction[random.integer(0, 2)] = scale;
    return result;
}

}  // namespace vitrine::test
