// SPDX-License-Identifier: MIT
// Builds the binary tree by the surface area heuristic, in one of three ways:
//
// - binned: the cheapest of the cuts between bins (Wald 2007, "On fast Construction of SAH-based
//   Bounding Volume Hierarchies"), and of all cuts where few items are left. Fast.
// - nine: the cheapest of nine cuts, three ways along three axes: the middle of the box, the median
//   of the items, and the bins. What a textbook does, and a check on the first.
// - spatial: may also cut triangles in two at a plane (Stich, Friedrich, Dietrich 2009, "Spatial
//   Splits in Bounding Volume Hierarchies"), which pays for long triangles across each other. Its
//   leaves may hold the same triangle several times. One thread.
//
// All of them:
// - The result is the same to the byte with any number of threads.
// - Depth never exceeds max(maxDepth, ceil(log2(n))); build.cpp gives the proof. The limit is far
//   above what scenes reach, it exists so that fixed stacks can be proven sufficient.
// - Boxes that cannot be told apart (equal centres) are divided by number: depth stays log2(n).
#pragma once

#include <span>

#include "bvh/bvh.hpp"

namespace vitrine {

enum class BuildMethod { kNine, kBinned, kSpatial };

struct BuildOptions {
    BuildMethod method = BuildMethod::kBinned;
    int maxLeafSize = 4;
    float traversalCost = 1;     ///< of one inner node, in the unit of
    float intersectionCost = 1;  ///< one item
    int bins = 32;               ///< 2 to 32 along each axis; small ranges use fewer
    int maxDepth = 48;           ///< at most 63
    /// Spatial: references to the same triangle beyond the first, as a part of all triangles.
    float maxDuplicates = 0.5f;
    /// Spatial: planes are tried where the children of the best other cut share at least this part
    /// of the root's area (alpha in the paper).
    float minOverlap = 1e-5f;
};

/// Precondition (asserted): every box is finite and not empty. Flat boxes are welcome. What is in
/// the boxes cannot be cut: not for BuildMethod::kSpatial.
Bvh buildBvh(std::span<const Aabb> boxes, const BuildOptions& options = {});

/// The same over the boxes of triangles. Precondition (asserted): corners are finite and exist.
Bvh buildTriangleBvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                     const BuildOptions& options = {});

}  // namespace vitrine
