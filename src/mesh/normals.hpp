// SPDX-License-Identifier: MIT
// Normals for meshes that come without.
#pragma once

#include <cstdint>
#include <vector>

namespace vitrine {

struct Mesh;

/// Which neighbouring triangles look like one smooth surface.
struct Smoothing {
    /// A triangle of this group follows `creaseDegrees`.
    static constexpr uint32_t kByAngle = 0xffffffffu;
    /// A triangle of this group is flat.
    static constexpr uint32_t kFlat = 0;

    /// Triangles whose normals differ by more than this meet in a sharp edge; 0 makes all flat
    /// ones. A cube (90) keeps its edges, an icosahedron (42) becomes a ball.
    float creaseDegrees = 50.0f;
    /// One a triangle: kFlat, kByAngle, or a group that is smooth inside and sharp against others.
    /// Empty: all by angle.
    std::vector<uint32_t> groups;
};

/// Gives a unit normal to every vertex whose normal is (0,0,0), and leaves the others alone.
/// Positions that are equal are one point; where sharp edges meet there, the vertex is split.
/// The mesh must have valid indices, no degenerate triangles, and full arrays.
void fillMissingNormals(Mesh& mesh, const Smoothing& smoothing = {});

}  // namespace vitrine
