// SPDX-License-Identifier: MIT
#include "mesh/tangents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "mesh/vertex_arrays.hpp"

namespace vitrine {
namespace {

/// The same number for vertices that differ in nothing that a tangent depends on.
std::vector<uint32_t> weldedVertices(const Mesh& mesh, const std::vector<glm::vec2>& uvs) {
    using Key = std::array<float, 8>;
    const auto keyOf = [&](uint32_t i) {
        const glm::vec3 &p = mesh.positions[i], &n = mesh.normals[i];
        return Key{p.x, p.y, p.z, n.x, n.y, n.z, uvs[i].x, uvs[i].y};
    };
    std::vector<uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return keyOf(a) < keyOf(b); });
    std::vector<uint32_t> welded(order.size());
    for (size_t i = 0; i < order.size(); ++i)
        welded[order[i]] =
            i > 0 && keyOf(order[i]) == keyOf(order[i - 1]) ? welded[order[i - 1]] : order[i];
    return welded;
}

/// Unit, or zero.
glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0);
}

glm::dvec3 across(const glm::dvec3& normal, const glm::dvec3& v) {
    return unit(v - glm::dot(v, normal) * normal);
}

struct TriangleFrame {
    glm::dvec3 alongU{0};
    bool mirrored = false;  ///< cross(normal, alongU) is not where v grows
};

TriangleFrame frameOf(const Mesh& mesh, const std::vector<glm::vec2>& uvs, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]);
    const glm::dvec3 edge1 = glm::dvec3(mesh.positions[t.y]) - a;
    const glm::dvec3 edge2 = glm::dvec3(mesh.positions[t.z]) - a;
    const glm::dvec2 uv1 = glm::dvec2(uvs[t.y]) - glm::dvec2(uvs[t.x]);
    const glm::dvec2 uv2 = glm::dvec2(uvs[t.z]) - glm::dvec2(uvs[t.x]);
    const double area = uv1.x * uv2.y - uv1.y * uv2.x;
    const double sign = area < 0 ? -1 : 1;
    const glm::dvec3 normal(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]);
    const bool inside = glm::dot(glm::cross(edge1, edge2), normal) < 0;
    TriangleFrame frame;
    if (area != 0) frame.alongU = unit(sign * (uv2.y * edge1 - uv1.y * edge2));
    frame.mirrored = (area < 0) != inside;
    return frame;
}

/// Of the triangle's corner in the plane of its normal, radians.
double cornerAngle(const Mesh& mesh, const glm::uvec3& t, int corner) {
    const glm::dvec3 normal(mesh.normals[t[corner]]), at(mesh.positions[t[corner]]);
    const auto towards = [&](int other) {
        return across(normal, glm::dvec3(mesh.positions[t[(corner + other) % 3]]) - at);
    };
    return std::acos(std::clamp(glm::dot(towards(1), towards(2)), -1.0, 1.0));
}

}  // namespace

void generateTangents(Mesh& mesh, bool secondUvs) {
    const std::vector<glm::vec2>& uvs = secondUvs && !mesh.uvs2.empty() ? mesh.uvs2 : mesh.uvs;
    const std::vector<uint32_t> welded = weldedVertices(mesh, uvs);
    const size_t vertices = mesh.positions.size();
    // For triangles that show the picture as it is, and for those that show it mirrored.
    std::array<std::vector<glm::dvec3>, 2> sums{std::vector<glm::dvec3>(vertices),
                                                std::vector<glm::dvec3>(vertices)};
    std::vector<bool> isMirrored(mesh.triangles.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const TriangleFrame frame = frameOf(mesh, uvs, t);
        isMirrored[i] = frame.mirrored;
        for (int corner = 0; corner < 3; ++corner)
            sums[frame.mirrored ? 1 : 0][welded[t[corner]]] +=
                cornerAngle(mesh, t, corner) *
                across(glm::dvec3(mesh.normals[t[corner]]), frame.alongU);
    }

    mesh.tangents.assign(vertices, glm::vec4(0));
    // The vertex that mirrored triangles use in place of one; itself while no others use it.
    std::vector<uint32_t> used(vertices, 0), twin(vertices);
    std::iota(twin.begin(), twin.end(), 0u);
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        if (!isMirrored[i])
            for (int corner = 0; corner < 3; ++corner) used[mesh.triangles[i][corner]] = 1;
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            uint32_t& vertex = mesh.triangles[i][corner];
            const glm::dvec3 sum = sums[isMirrored[i] ? 1 : 0][welded[vertex]];
            if (isMirrored[i] && used[vertex] != 0) {
                if (twin[vertex] == vertex) {
                    twin[vertex] = static_cast<uint32_t>(mesh.positions.size());
                    forEachVertexArray(mesh, [&](auto& array) {
                        const auto copy = array[vertex];
                        array.push_back(copy);
                    });
                }
                vertex = twin[vertex];
            }
            mesh.tangents[vertex] = glm::vec4(glm::vec3(unit(sum)), isMirrored[i] ? -1.0f : 1.0f);
        }
}

}  // namespace vitrine
