// SPDX-License-Identifier: MIT
// Parts of a mesh whose backs nobody outside of them sees, so that a rasteriser may leave them out.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace vitrine {

/// A solid: triangles joined by edges, each of which has two triangles that run along it in
/// opposite directions, fronts outside. Either all face away from one point inside and surround it
/// once, or the surface does not meet itself (mesh/self_contact.hpp). A ray from outside meets its
/// front first: a back before it would be the way out of what the ray has not yet entered. Holes
/// are closed by triangles that are not there; from in front of one of these, backs are seen
/// through it.
struct Shell {
    uint32_t first = 0, count = 0;  ///< in Shells::order
    Aabb box;
    std::vector<glm::vec4> holes;  ///< planes of those triangles: xyz normal outwards, w distance

    /// True if an eye there, in object space, sees no back of any triangle of the shell but through
    /// its front.
    [[nodiscard]] bool hidesBacks(const glm::vec3& eye) const;
};

struct Shells {
    std::vector<uint32_t> order;  ///< all triangles of the mesh: those of the shells, then the rest
    std::vector<Shell> shells;
};

/// Takes time N log N, about a second for a million triangles. Vertices count as one where their
/// positions are equal.
Shells findShells(const Mesh& mesh);

}  // namespace vitrine
