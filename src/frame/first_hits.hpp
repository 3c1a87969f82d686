// SPDX-License-Identifier: MIT
// What the camera sees, by the rasteriser: the meshes' triangles, and the fields in front of them.
#pragma once

#include <span>

#include "frame/passes.hpp"

namespace vitrine {

/// How the fields are found.
enum class FieldFinder {
    kFaster,  ///< by their boxes, unless these cover the picture too many times over
    kBoxes,   ///< their boxes are drawn, and every pixel of a box marches through its field
    kTree,    ///< every pixel traces the tree over them, which passes by what is hidden
};

/// Fills `records`. `spare`: an image like it, whose content is lost. `fieldRoot`: see
/// PackedMoment.
void rasterFirstHits(PassContext& context, std::span<const PackedInstance> instances, int fieldRoot,
                     FieldFinder finder, const DepthImage& depth, Texture& spare, Texture& records);

}  // namespace vitrine
