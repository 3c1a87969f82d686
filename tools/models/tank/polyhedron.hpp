// SPDX-License-Identifier: MIT
// Bodies with flat faces and bevelled edges. A bevel is one strip: its two sides take the normals
// of the faces that they touch, so the light runs around the edge as around a rounded one.
#pragma once

#include "models/tank/solid.hpp"

namespace vitrine::tank {

/// Closed; faces wind counter-clockwise seen from outside and may be concave.
struct Polyhedron {
    std::vector<Vec3> points;
    std::vector<std::vector<uint32_t>> faces;
};

/// The half space dot(normal, p) <= offset.
struct Plane {
    Vec3 normal;
    double offset;

    /// Through a point.
    static Plane at(const Vec3& point, const Vec3& outward) {
        const Vec3 n = glm::normalize(outward);
        return {n, glm::dot(n, point)};
    }
};

Polyhedron box(const Vec3& low, const Vec3& high);
/// `outline` in x and y, from z = low to z = high; it may wind either way.
Polyhedron prism(std::vector<Vec2> outline, double low, double high);
/// Through rings of as many points each, from the first to the last; it may wind either way.
Polyhedron loft(const std::vector<std::vector<Vec3>>& rings);
/// What all planes have in common; it must be bounded.
Polyhedron convex(const std::vector<Plane>& planes);
/// `sides` corners on a circle about the origin, the first one half a side above the x axis.
std::vector<Vec2> regularPolygon(int sides, double radius);

/// A prism of which only the edges along z are bevelled: less than half the triangles.
Solid softBar(const std::vector<Vec2>& outline, double low, double high, double width,
              Material material);
/// The same of a box.
Solid softBar(const Vec3& low, const Vec3& high, double width, Material material);

/// `width` is measured on each face, from the edge inwards; faces that are too small get less.
Solid bevelled(const Polyhedron& body, double width, Material material);

}  // namespace vitrine::tank
