// SPDX-License-Identifier: MIT
// Collapse of the binary tree into nodes of up to four children: fewer, fuller steps per ray.
// A node opens its largest child by area, the one most rays meet, until it is full (Wald, Benthin,
// Boulos 2008, "Getting Rid of Packets").
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/bvh.hpp"

namespace vitrine {

inline constexpr int kWideWidth = 4;

struct WideChild {
    Aabb box;
    bool leaf = true;
    uint32_t first = 0;  ///< leaf: first of `count` items of the binary tree; inner: a wide node
    uint32_t count = 0;
};

/// Children [0, childCount) are used, the others are empty boxes.
struct WideNode {
    std::array<WideChild, kWideWidth> children;
    int childCount = 0;
};

/// Node 0 is the root, parents come before children. No items, no nodes; a tree of one leaf
/// becomes one node with one child.
std::vector<WideNode> collapse4(const Bvh& bvh);

/// The exact number of stack entries that the worst ray needs in a traversal that goes on with one
/// of the children it meets and pushes the others, leaves too.
int wideStackBound(std::span<const WideNode> nodes);

}  // namespace vitrine
