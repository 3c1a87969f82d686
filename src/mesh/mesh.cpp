// SPDX-License-Identifier: MIT
#include "mesh/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/vertex_arrays.hpp"

namespace vitrine {
namespace {

// A float cross product of two edges of length L is wrong by up to about 6e-8 L^2.
constexpr double kSliver = 1e-7;
// Below this the squared length of a float normal leaves the range of normal floats.
constexpr double kTinyArea = 1e-18;

bool isUsable(const glm::vec3& p) {
    return std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate &&
           std::abs(p.z) <= kMaxCoordinate;
}

struct Dropped {
    size_t outOfRange = 0, notFinite = 0, degenerate = 0;
};

/// Keeps the good triangles in their order, with their parts and smoothing groups.
Dropped dropBadTriangles(Mesh& mesh, std::vector<uint32_t>& groups) {
    Dropped dropped;
    const size_t count = mesh.positions.size();
    size_t kept = 0;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3 v = mesh.triangles[t];
        if (v.x >= count || v.y >= count || v.z >= count ||
            mesh.triangleParts[t] >= mesh.partNames.size()) {
            ++dropped.outOfRange;
            continue;
        }
        const glm::vec3 &a = mesh.positions[v.x], &b = mesh.positions[v.y],
                        &c = mesh.positions[v.z];
        if (!isUsable(a) || !isUsable(b) || !isUsable(c)) {
            ++dropped.notFinite;
            continue;
        }
        if (isDegenerate(a, b, c)) {
            ++dropped.degenerate;
            continue;
        }
        mesh.triangles[kept] = v;
        mesh.triangleParts[kept] = mesh.triangleParts[t];
        if (!groups.empty()) groups[kept] = groups[t];
        ++kept;
    }
    mesh.triangles.resize(kept);
    mesh.triangleParts.resize(kept);
    if (!groups.empty()) groups.resize(kept);
    return dropped;
}

/// An unused vertex may hold anything, NaN too, and would spoil the bounds.
void removeUnusedVertices(Mesh& mesh) {
    constexpr uint32_t kUnused = 0xffffffffu;
    std::vector<uint32_t> newIndex(mesh.positions.size(), kUnused);
    for (const glm::uvec3& v : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) newIndex[v[corner]] = 0;
    uint32_t used = 0;
    for (size_t i = 0; i < newIndex.size(); ++i) {
        if (newIndex[i] == kUnused) continue;
        newIndex[i] = used;
        forEachVertexArray(mesh, [&](auto& array) { array[used] = array[i]; });
        ++used;
    }
    forEachVertexArray(mesh, [&](auto& array) { array.resize(used); });
    for (glm::uvec3& v : mesh.triangles) v = {newIndex[v.x], newIndex[v.y], newIndex[v.z]};
}

/// Unit length, or zero for "missing". Doubles, because the squares of huge and of tiny floats
/// are no floats.
glm::vec3 unitOrZero(const glm::vec3& n) {
    if (!isFinite(n)) return glm::vec3(0.0f);
    const glm::dvec3 wide(n);
    const double length = glm::length(wide);
    return length > 0.0 ? glm::vec3(wide / length) : glm::vec3(0.0f);
}

template <typename Vector>
bool isFiniteVector(const Vector& v) {
    for (int i = 0; i < v.length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

void replaceNonFinite(auto& array, const auto& replacement) {
    for (auto& value : array)
        if (!isFiniteVector(value)) value = replacement;
}

/// One entry a position, everywhere. What is added counts as missing.
void resizeArrays(Mesh& mesh) {
    const size_t count = mesh.positions.size();
    mesh.normals.resize(count, glm::vec3(0.0f));
    mesh.uvs.resize(count, glm::vec2(0.0f));
    if (!mesh.uvs2.empty()) mesh.uvs2.resize(count, glm::vec2(0.0f));
    if (!mesh.colors.empty()) mesh.colors.resize(count, glm::vec4(1.0f));
    if (!mesh.tangents.empty()) mesh.tangents.resize(count, glm::vec4(0.0f));
}

/// Any unit vector across `n`, for a surface whose texture has no direction.
glm::vec3 perpendicular(const glm::vec3& n) {
    const glm::vec3 axis = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(glm::cross(n, axis));
}

/// Needs the final normals.
void repairTangents(Mesh& mesh) {
    for (size_t i = 0; i < mesh.tangents.size(); ++i) {
        glm::vec3 direction = unitOrZero(glm::vec3(mesh.tangents[i]));
        if (direction == glm::vec3(0.0f)) direction = perpendicular(mesh.normals[i]);
        mesh.tangents[i] = glm::vec4(direction, mesh.tangents[i].w < 0.0f ? -1.0f : 1.0f);
    }
}

std::string counted(size_t count, const char* what) {
    return fmt::format("{} triangle{} {}", count, count == 1 ? "" : "s", what);
}

}  // namespace

Aabb bounds(const Mesh& mesh) {
    Aabb box;
    for (const glm::vec3& p : mesh.positions) box.grow(p);
    return box;
}

bool isDegenerate(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a), ac = glm::dvec3(c) - glm::dvec3(a),
                     bc = glm::dvec3(c) - glm::dvec3(b);
    const double twiceArea = glm::length(glm::cross(ab, ac));
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    return !(twiceArea > kTinyArea && twiceArea > kSliver * longest);
}

void sanitizeMesh(Mesh& mesh, const SourceLocation& where, Diagnostics& diagnostics,
                  Smoothing smoothing) {
    if (mesh.partNames.empty()) mesh.partNames.emplace_back("default");
    resizeArrays(mesh);
    mesh.triangleParts.resize(mesh.triangles.size(), 0);
    if (!smoothing.groups.empty())
        smoothing.groups.resize(mesh.triangles.size(), Smoothing::kByAngle);

    const bool wasEmpty = mesh.triangles.empty();
    const Dropped dropped = dropBadTriangles(mesh, smoothing.groups);
    if (dropped.outOfRange > 0)
        diagnostics.error(where, counted(dropped.outOfRange, "with an index out of range"));
    if (dropped.notFinite > 0)
        diagnostics.warning(where, counted(dropped.notFinite,
                                           "dropped: infinite, huge or not-a-number coordinates"));
    if (dropped.degenerate > 0)
        diagnostics.warning(where, counted(dropped.degenerate, "dropped: no area"));
    if (mesh.triangles.empty())
        diagnostics.error(
            where, wasEmpty ? "the mesh has no triangles" : "the mesh has no usable triangle left");

    removeUnusedVertices(mesh);
    for (glm::vec3& n : mesh.normals) n = unitOrZero(n);
    replaceNonFinite(mesh.uvs, glm::vec2(0.0f));
    replaceNonFinite(mesh.uvs2, glm::vec2(0.0f));
    replaceNonFinite(mesh.colors, glm::vec4(1.0f));
    fillMissingNormals(mesh, smoothing);
    repairTangents(mesh);
}

}  // namespace vitrine
