// SPDX-License-Identifier: MIT
// A triangle mesh as the rest of Vitrine wants it, and the gate every mesh passes on its way in:
// behind sanitizeMesh() there are no NaNs, no degenerate triangles and no index out of range.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/aabb.hpp"
#include "base/error.hpp"
#include "base/math.hpp"
#include "mesh/normals.hpp"

namespace vitrine {

/// Triangles wind counter-clockwise seen from outside. Where v grows is the bitangent,
/// cross(normal, tangent.xyz) * tangent.w.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< unit, one a position
    std::vector<glm::vec2> uvs;      ///< one a position; (0,0) is the lower left of a picture
    std::vector<glm::vec2> uvs2;     ///< a second set; none, or one a position
    std::vector<glm::vec4> colors;   ///< linear RGBA; none, or one a position
    std::vector<glm::vec4>
        tangents;  ///< where u grows, unit or zero, and a sign; none, or one a position
    std::vector<glm::uvec3> triangles;    ///< indices of positions
    std::vector<uint32_t> triangleParts;  ///< one a triangle, index into partNames
    std::vector<std::string> partNames;   ///< at least one; a scene gives materials to parts
};

/// Coordinates beyond this are taken for infinite: their squares still fit a float.
inline constexpr float kMaxCoordinate = 1e18f;

/// The box around all positions.
Aabb bounds(const Mesh& mesh);

/// True if the triangle's normal is lost in the rounding of floats: equal corners, corners in one
/// line, slivers thinner than about 1e-7 of their length, or less than about a nanometre across.
bool isDegenerate(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Makes a mesh from outside safe: one that fulfils every comment in `Mesh`, all finite.
/// - an index out of range is an error;
/// - triangles with non-finite or huge positions, and degenerate ones, are dropped with one counted
///   warning each;
/// - arrays that are too short are filled up: normals are generated after `smoothing` where they
///   are zero, non-finite or missing, and are made unit length elsewhere; uvs become zero;
/// - optional arrays stay empty, or else are filled up too: the second uvs become zero, colours
///   white, tangents any direction along the surface;
/// - vertices that no triangle uses are removed;
/// - a mesh without any triangle left is an error.
/// All diagnostics are placed at `where`.
void sanitizeMesh(Mesh& mesh, const SourceLocation& where, Diagnostics& diagnostics,
                  Smoothing smoothing = {});

}  // namespace vitrine
