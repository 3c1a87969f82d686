// SPDX-License-Identifier: MIT
// Seams and poles repeat positions, never approximately: both sides of a seam read the same entry
// of one table of sines, so that an edge is bit for bit the same seen from its two triangles.
#include "mesh/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine {
namespace {

Mesh startMesh(const char* name) {
    Mesh mesh;
    mesh.name = name;
    mesh.partNames = {"default"};
    return mesh;
}

uint32_t addVertex(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal,
                   const glm::vec2& uv) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.uvs.push_back(uv);
    return static_cast<uint32_t>(mesh.positions.size() - 1);
}

void addTriangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t part = 0) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangleParts.push_back(part);
}

/// Corners counter-clockwise.
void addQuad(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t part = 0) {
    addTriangle(mesh, a, b, c, part);
    addTriangle(mesh, a, c, d, part);
}

/// (cos, sin) of count + 1 angles around the circle, or this part of it; after a whole turn the
/// last is the first again, and quarter turns are exact.
std::vector<glm::vec2> circle(int count, double turns = 1.0) {
    std::vector<glm::vec2> points;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2.0 * glm::pi<double>() * turns * i / count;
        glm::dvec2 p(std::cos(angle), std::sin(angle));
        for (int k = 0; k < 2; ++k)
            if (std::abs(p[k]) < 1e-15) p[k] = 0.0;
        points.emplace_back(p);
    }
    return points;
}

float fraction(int i, int count) {
    return static_cast<float>(i) / static_cast<float>(count);
}

}  // namespace

Mesh makeBox(const glm::vec3& halfExtents) {
    Mesh mesh = startMesh("box");
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f), up(0.0f, axis == 1 ? 0.0f : 1.0f, axis == 1 ? -side : 0.0f);
            normal[axis] = side;
            const glm::vec3 right = glm::cross(up, normal);
            const auto corner = [&](float u, float v) {
                const glm::vec3 p = normal + (2.0f * u - 1.0f) * right + (2.0f * v - 1.0f) * up;
                return addVertex(mesh, p * halfExtents, normal, {u, v});
            };
            const uint32_t a = corner(0.0f, 0.0f), b = corner(1.0f, 0.0f), c = corner(1.0f, 1.0f),
                           d = corner(0.0f, 1.0f);
            addQuad(mesh, a, b, c, d);
        }
    return mesh;
}

Mesh makeSphere(float radius, int subdivisions) {
    Mesh mesh = startMesh("sphere");
    const int rows = std::max(subdivisions, 2), columns = 2 * rows;
    const std::vector<glm::vec2> around = circle(columns);
    for (int row = 0; row <= rows; ++row) {
        // Half of the circle from the south pole; a full one has twice as many steps.
        const float ring = row == rows ? 0.0f : around[row].y, height = -around[row].x;
        const bool pole = row == 0 || row == rows;
        for (int column = 0; column <= columns; ++column) {
            const glm::vec3 n(ring * around[column].x, height, -ring * around[column].y);
            // Each triangle at a pole has a pole vertex of its own, with the u of its middle.
            const float u =
                (static_cast<float>(column) + (pole ? 0.5f : 0.0f)) / static_cast<float>(columns);
            addVertex(mesh, radius * n, n, {u, fraction(row, rows)});
        }
    }
    const auto at = [columns](int row, int column) {
        return static_cast<uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const uint32_t a = at(row, column), b = at(row, column + 1),
                           c = at(row + 1, column + 1), d = at(row + 1, column);
            if (row == 0)
                addTriangle(mesh, a, c, d);
            else if (row == rows - 1)
                addTriangle(mesh, a, b, d);
            else
                addQuad(mesh, a, b, c, d);
        }
    return mesh;
}

Mesh makePlane(float halfX, float halfZ) {
    Mesh mesh = startMesh("plane");
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    addVertex(mesh, {-halfX, 0.0f, halfZ}, up, {0.0f, 0.0f});
    addVertex(mesh, {halfX, 0.0f, halfZ}, up, {1.0f, 0.0f});
    addVertex(mesh, {halfX, 0.0f, -halfZ}, up, {1.0f, 1.0f});
    addVertex(mesh, {-halfX, 0.0f, -halfZ}, up, {0.0f, 1.0f});
    addQuad(mesh, 0, 1, 2, 3);
    return mesh;
}

Mesh makeTorus(float ringRadius, float tubeRadius, int segments, int sides, float arc) {
    Mesh mesh = startMesh("torus");
    segments = std::max(segments, 3);
    sides = std::max(sides, 3);
    const bool closed = arc >= 360.0f;
    const std::vector<glm::vec2> ring = circle(segments, closed ? 1.0 : arc / 360.0);
    const std::vector<glm::vec2> tube = circle(sides);
    const auto outward = [&](int i) { return glm::vec3(ring[i].x, 0.0f, -ring[i].y); };
    const auto tubeNormal = [&](int i, int j) {
        return tube[j].x * outward(i) + glm::vec3(0.0f, tube[j].y, 0.0f);
    };
    const auto position = [&](int i, int j) {
        return ringRadius * outward(i) + tubeRadius * tubeNormal(i, j);
    };
    for (int i = 0; i <= segments; ++i)
        for (int j = 0; j <= sides; ++j)
            addVertex(mesh, position(i, j), tubeNormal(i, j),
                      {fraction(i, segments), fraction(j, sides)});
    const auto at = [sides](int i, int j) { return static_cast<uint32_t>(i * (sides + 1) + j); };
    for (int i = 0; i < segments; ++i)
        for (int j = 0; j < sides; ++j)
            addQuad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    if (closed) return mesh;

    for (const int end : {0, segments}) {
        const float side = end == 0 ? -1.0f : 1.0f;
        const glm::vec3 normal = side * glm::vec3(-ring[end].y, 0.0f, -ring[end].x);
        const auto uv = [&](const glm::vec2& p) {
            return 0.5f + 0.5f * glm::vec2(-side * p.x, p.y);
        };
        const uint32_t centre = addVertex(mesh, ringRadius * outward(end), normal, glm::vec2(0.5f));
        for (int j = 0; j < sides; ++j) addVertex(mesh, position(end, j), normal, uv(tube[j]));
        for (int j = 0; j < sides; ++j) {
            uint32_t a = centre + 1 + j, b = centre + 1 + (j + 1) % sides;
            if (end != 0) std::swap(a, b);
            addTriangle(mesh, centre, a, b);
        }
    }
    return mesh;
}

Mesh makeCylinder(float radius, float halfHeight, int segments) {
    Mesh mesh = startMesh("cylinder");
    mesh.partNames = {"side", "top", "bottom"};
    segments = std::max(segments, 3);
    const std::vector<glm::vec2> around = circle(segments);
    for (int i = 0; i <= segments; ++i) {
        const glm::vec3 n(around[i].x, 0.0f, -around[i].y), rise(0.0f, halfHeight, 0.0f);
        addVertex(mesh, radius * n - rise, n, {fraction(i, segments), 0.0f});
        addVertex(mesh, radius * n + rise, n, {fraction(i, segments), 1.0f});
    }
    for (uint32_t i = 0; i < static_cast<uint32_t>(segments); ++i)
        addQuad(mesh, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);

    for (const float side : {1.0f, -1.0f}) {
        const uint32_t part = side > 0.0f ? 1 : 2;
        const glm::vec3 n(0.0f, side, 0.0f);
        const uint32_t centre = addVertex(mesh, halfHeight * n, n, {0.5f, 0.5f});
        for (int i = 0; i < segments; ++i) {
            const glm::vec3 p(radius * around[i].x, side * halfHeight, -radius * around[i].y);
            addVertex(mesh, p, n, 0.5f + 0.5f * glm::vec2(around[i].x, side * around[i].y));
        }
        for (int i = 0; i < segments; ++i) {
            uint32_t a = centre + 1 + i, b = centre + 1 + (i + 1) % segments;
            if (side < 0.0f) std::swap(a, b);
            addTriangle(mesh, centre, a, b, part);
        }
    }
    return mesh;
}

}  // namespace vitrine
