// SPDX-License-Identifier: MIT
// Builds the binary tree by the surface area heuristic, evaluated at bins (Wald 2007, "On fast
// Construction of SAH-based Bounding Volume Hierarchies"), and exactly where few items are left.
//
// - The result is the same to the byte with any number of threads.
// - Depth never exceeds max(maxDepth, ceil(log2(n))); build.cpp gives the proof. The limit is far
//   above what scenes reach, it exists so that fixed stacks can be proven sufficient.
// - Boxes that cannot be told apart (equal centres) are divided by number: depth stays log2(n).
#pragma once

#include <span>

#include "bvh/bvh.hpp"

namespace vitrine {

struct BuildOptions {
    int maxLeafSize = 4;
    float traversalCost = 1;     ///< of one inner node, in the unit of
    float intersectionCost = 1;  ///< one item
    int bins = 32;               ///< 2 to 32 along each axis; small ranges use fewer
    int maxDepth = 48;           ///< at most 63
};

/// Precondition (asserted): every box is finite and not empty. Flat boxes are welcome.
Bvh buildBvh(std::span<const Aabb> boxes, const BuildOptions& options = {});

/// The same over the boxes of triangles. Precondition (asserted): corners are finite and exist.
Bvh buildTriangleBvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                     const BuildOptions& options = {});

}  // namespace vitrine
