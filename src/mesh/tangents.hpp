// SPDX-License-Identifier: MIT
// Tangents for meshes that come without, close to those that normal maps are baked for.
#pragma once

namespace vitrine {

struct Mesh;

/// Replaces the tangents of a mesh that has passed sanitizeMesh() by those of its texture
/// coordinates, the second set or the first. As MikkTSpace (Mikkelsen, "Simulation of Wrinkled
/// Surfaces Revisited", 2008) does, the directions of u in the triangles around a corner are
/// averaged by angle, in the plane of its normal; corners of equal position, normal and coordinates
/// are one; and where the picture is mirrored, the vertex is split. Unlike it, triangles need not
/// share an edge to be averaged. Zero where the coordinates have no direction.
void generateTangents(Mesh& mesh, bool secondUvs);

}  // namespace vitrine
