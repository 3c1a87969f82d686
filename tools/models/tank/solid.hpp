// SPDX-License-Identifier: MIT
// Triangles in the making: every corner has its own normal, so that an edge is hard or soft as the
// code that makes it wants. A Solid has no texture coordinates; unwrap.hpp gives them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/math.hpp"

namespace vitrine::tank {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat4 = glm::dmat4;

inline constexpr double kTau = 6.283185307179586;

/// What a surface is made of; also the parts of the meshes, under these names.
enum class Material : uint8_t { kPaint, kSteel, kTrack, kRubber, kGlass, kWood, kCanvas, kLamp };
inline constexpr std::array kMaterialNames = {"paint", "steel", "track",  "rubber",
                                              "glass", "wood",  "canvas", "lamp"};

struct Corner {
    Vec3 at, normal;
};

struct Triangle {
    std::array<Corner, 3> corners;
    Material material;
};

struct Solid {
    std::vector<Triangle> triangles;

    /// Turned so that it faces as its normals do; left out if it has no area.
    void triangle(Material material, const Corner& a, const Corner& b, const Corner& c);
    /// Around its rim a, b, c, d.
    void quad(Material material, const Corner& a, const Corner& b, const Corner& c,
              const Corner& d);
    void append(const Solid& other, const Mat4& at = Mat4(1.0));
    /// Also what is on the other side of the tank: mirrored at z = 0.
    void appendBothSides(const Solid& other, const Mat4& at = Mat4(1.0));
};

Mat4 moved(const Vec3& by);
/// Degrees about x, then y, then z; the order of the scenes' `rotate`.
Mat4 turned(const Vec3& degrees);
/// Puts the origin at `at` and the y axis along `up`; x stays as near to `ahead` as it can.
Mat4 standing(const Vec3& at, const Vec3& up, const Vec3& ahead = {1, 0, 0});

}  // namespace vitrine::tank
