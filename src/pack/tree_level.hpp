// SPDX-License-Identifier: MIT
// One level of the trees of a packed scene, to be drawn or written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pack/pack_scene.hpp"

namespace vitrine {

/// Trees are no deeper than 63.
inline constexpr int kMaxTreeLevel = 63;
/// More are refused.
inline constexpr size_t kMaxTreeBoxes = 1u << 20;

struct TreeBox {
    uint32_t instance;
    Aabb box;             ///< object space of the instance, m
    bool lonely = false;  ///< of a mesh of so few triangles that its tree is one leaf
};

struct TreeLevel {
    /// Instance by instance, in each from left to right through the tree: a mesh gives the nodes
    /// so many edges below its root and the leaves above, a field its bounds.
    std::vector<TreeBox> boxes;
    /// Of each instance, in `boxes`; one more at the end.
    std::vector<uint32_t> firstBox;
    /// Of each entry of PackedScene::triangles: in which box of its instance it is, counted from
    /// the instance's first. A triangle that was cut is in the first one of several.
    std::vector<uint32_t> boxOfTriangle;
};

/// `level` is 0 to kMaxTreeLevel. Throws UsageError if there are too many boxes.
TreeLevel treeLevel(std::span<const PackedInstance> instances, int level);

/// The boxes in the world as a Wavefront OBJ: an object an instance, of quads that wind
/// counter-clockwise seen from outside. A flat box has two faces.
std::string objOfTreeLevel(std::span<const PackedInstance> instances, const TreeLevel& level);

}  // namespace vitrine
