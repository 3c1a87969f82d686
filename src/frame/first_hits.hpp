// SPDX-License-Identifier: MIT
// What the camera sees, by the rasteriser: the meshes' triangles, and the fields in front of them.
#pragma once

#include <span>
#include <vector>

#include "frame/passes.hpp"

namespace vitrine {

/// How the fields are found.
enum class FieldFinder {
    kFaster,  ///< by their boxes, unless these cover the picture too many times over
    kBoxes,   ///< their boxes are drawn, and every pixel of a box marches through its field
    kTree,    ///< every pixel traces the tree over them, which passes by what is hidden
};

/// What is in view, and how its fields will be found.
struct FirstHitPlan {
    std::vector<RasterDraw> meshes;
    FieldBoxes fields;
    bool byTree = false;
};
FirstHitPlan planFirstHits(PassContext& context, std::span<const PackedInstance> instances,
                           FieldFinder finder);
/// The meshes of the whole picture, whatever the context's rows. `spare`: an image like `records`.
void rasterMeshes(PassContext& context, const FirstHitPlan& plan, const DepthImage& depth,
                  Texture& spare, Texture& records);
/// After that, the fields in front of them, in the context's rows; with counters, which are written
/// as a whole, in all. `fieldRoot`: see PackedMoment.
void findFields(PassContext& context, const FirstHitPlan& plan, int fieldRoot,
                const DepthImage& depth, const Texture& spare, Texture& records);

/// All of that. Fills `records`; the content of `spare` is lost.
void rasterFirstHits(PassContext& context, std::span<const PackedInstance> instances, int fieldRoot,
                     FieldFinder finder, const DepthImage& depth, Texture& spare, Texture& records);

}  // namespace vitrine
