// SPDX-License-Identifier: MIT
// A bumpy torus knot with about as many triangles as asked for: a closed mesh with curvature,
// self-occlusion and triangles of several sizes, made from a formula.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "base/math.hpp"

namespace vitrine {

struct KnotMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
};

inline KnotMesh makeTorusKnot(uint32_t triangleCount) {
    // Rings of the tube are about eight times as many as the corners of a ring.
    const auto sides = uint32_t(std::sqrt(double(triangleCount) / 16));
    const uint32_t rings = triangleCount / (2 * sides);
    const auto centre = [](float a) {
        const float radius = 2 + std::cos(3 * a);
        return glm::vec3(radius * std::cos(2 * a), radius * std::sin(2 * a), std::sin(3 * a));
    };

    KnotMesh mesh;
    for (uint32_t ring = 0; ring < rings; ++ring) {
        const float a = 2 * kPi * float(ring) / float(rings);
        const glm::vec3 tangent = glm::normalize(centre(a + 1e-3f) - centre(a - 1e-3f));
        const glm::vec3 side = glm::normalize(glm::cross(tangent, glm::vec3(0.1f, 0.2f, 1)));
        const glm::vec3 up = glm::cross(side, tangent);
        for (uint32_t corner = 0; corner < sides; ++corner) {
            const float b = 2 * kPi * float(corner) / float(sides);
            const float bumps =
                std::sin(40 * a) * std::sin(7 * b) + 0.3f * std::sin(173 * a + 11 * b);
            const float radius = 0.4f + 0.05f * bumps;
            mesh.positions.push_back(centre(a) + radius * (std::cos(b) * side + std::sin(b) * up));
            const uint32_t nextRing = (ring + 1) % rings * sides;
            const uint32_t nextCorner = (corner + 1) % sides;
            const uint32_t here = ring * sides;
            mesh.triangles.push_back({here + corner, nextRing + corner, nextRing + nextCorner});
            mesh.triangles.push_back({here + corner, nextRing + nextCorner, here + nextCorner});
        }
    }
    return mesh;
}

}  // namespace vitrine
