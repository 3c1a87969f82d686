// SPDX-License-Identifier: MIT
#include "frame/first_hits.hpp"

namespace vitrine {
namespace {

/// Boxes that cover the picture more often are slower than the tree: they march in vain through
/// what is hidden (docs/performance.md has the crossing). Boxes that the eye stands in do not
/// count, because no ray passes by them in a tree either.
constexpr float kMostCover = 2;

}  // namespace

void rasterFirstHits(PassContext& context, std::span<const PackedInstance> instances, int fieldRoot,
                     FieldFinder finder, const DepthImage& depth, Texture& spare,
                     Texture& records) {
    const std::vector<RasterDraw> meshes = rasterDraws(context, instances);
    const FieldBoxes fields = fieldBoxes(context.block, instances);
    const bool tooMany = finder == FieldFinder::kFaster && fields.cover > kMostCover;
    if (!fields.groups.empty() && (tooMany || finder == FieldFinder::kTree)) {
        rasterPass(context, meshes, depth, spare);
        visibilityFieldsPass(context, fieldRoot, spare, records);
        return;
    }
    const bool fieldsAlone = meshes.empty() && !fields.groups.empty();
    if (!fieldsAlone) rasterPass(context, meshes, depth, records);
    if (!fields.groups.empty()) marchPass(context, fields, depth, fieldsAlone, records);
}

}  // namespace vitrine
