// SPDX-License-Identifier: MIT
// One level of a binary tree, to be looked at.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/bvh.hpp"

namespace vitrine {

/// The nodes `level` edges below the root, and the leaves above: together they hold every item.
/// From left to right, so that neighbours in the list are neighbours in the tree.
/// `level` is not negative. Nothing for an empty tree.
std::vector<uint32_t> nodesOfLevel(const Bvh& bvh, int level);

/// The items of all leaves of the subtree, in the order of the leaves: items below a node lie side
/// by side in Bvh::items. Returns the first of them and how many there are.
struct ItemRange {
    uint32_t first = 0, count = 0;
};
ItemRange itemsBelow(const Bvh& bvh, uint32_t node);

}  // namespace vitrine
