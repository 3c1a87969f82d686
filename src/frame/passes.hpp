// SPDX-License-Identifier: MIT
// The passes. Each takes images and fills images, lives in pass_NAME.cpp and runs the shader
// shaders/pass/NAME.glsl. frame.cpp strings them together.
#pragma once

#include "frame/layers.hpp"
#include "frame/lens_filter.hpp"
#include "frame/pass_context.hpp"
#include "frame/tree_boxes.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

/// Camera rays: the first hits.
void visibilityPass(PassContext& context, Texture& records);

/// What the rasteriser is to draw: the meshes that may be in view, the nearest first.
std::vector<RasterDraw> rasterDraws(PassContext& context,
                                    std::span<const PackedInstance> instances);
/// Camera rays by rasterising the meshes.
void rasterPass(PassContext& context, std::span<const RasterDraw> draws, const DepthImage& depth,
                Texture& records);
/// The boxes of the fields that may be in view.
struct FieldBoxes {
    /// Drawn by one program, the nearest first.
    struct Group {
        int field = kAllFields;  ///< the only field that they are of
        std::vector<BoxDraw> boxes;
    };
    std::vector<Group> groups;
    /// How many times over they cover the picture, roughly. Those that the eye stands in or nearly
    /// touches are not counted.
    float cover = 0;
};
FieldBoxes fieldBoxes(const FrameBlock& block, std::span<const PackedInstance> instances);
/// Camera rays by marching through the fields whose boxes they meet. `first`: nothing has been
/// found before; else records and depth are those of rasterPass().
void marchPass(PassContext& context, const FieldBoxes& boxes, const DepthImage& depth, bool first,
               Texture& records);
/// Instead of that: by tracing the tree over the fields, rooted at this slot, in front of `meshes`.
void visibilityFieldsPass(PassContext& context, int fieldRoot, const Texture& meshes,
                          Texture& records);

/// Light that leaves the hits along their paths, added to `before`.
void lightPass(PassContext& context, const PathImages& path, const Texture& before, Texture& after);

/// The next ray of every path and what it hits.
void bouncePass(PassContext& context, const PathImages& from, PathImages& to);

/// The running mean of all samples.
void accumulatePass(PassContext& context, const Texture& radiance, const Texture& before,
                    Texture& after);

/// What the records or the counters say, as a colour.
void viewPass(PassContext& context, const Texture& records, Texture& radiance);

/// Boxes of the trees over the picture, which is dimmed; `records` are of the same moment.
void boxesPass(PassContext& context, const TreeBoxes& boxes, const Texture& records,
               Texture& picture);
/// What the records say, as data.
void layersPass(PassContext& context, const Texture& records, LayerTextures& layers);

/// The steps of LensFilter, in their order.
void focusLevelsPass(PassContext& context, const Texture& mean, const Texture& records,
                     FocusImages& images);
void focusReachPass(PassContext& context, FocusImages& images);
void focusPass(PassContext& context, const FocusImages& images, Texture& blurred);

/// From the mean to 8 bits.
void displayPass(PassContext& context, const Texture& mean, Texture& picture);

}  // namespace vitrine
