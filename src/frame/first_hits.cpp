// SPDX-License-Identifier: MIT
#include "frame/first_hits.hpp"

namespace vitrine {
namespace {

/// Boxes that cover the picture more often are slower than the tree: they march in vain through
/// what is hidden (docs/performance.md has the crossing). Boxes that the eye stands in do not
/// count, because no ray passes by them in a tree either.
constexpr float kMostCover = 2;

}  // namespace

FirstHitPlan planFirstHits(PassContext& context, std::span<const PackedInstance> instances,
                           FieldFinder finder) {
    FirstHitPlan plan{rasterDraws(context, instances), fieldBoxes(context.block, instances)};
    const bool tooMany = finder == FieldFinder::kFaster && plan.fields.cover > kMostCover;
    plan.byTree = !plan.fields.groups.empty() && (tooMany || finder == FieldFinder::kTree);
    return plan;
}

void rasterMeshes(PassContext& context, const FirstHitPlan& plan, const DepthImage& depth,
                  Texture& spare, Texture& records) {
    const bool fieldsAlone = plan.meshes.empty() && !plan.fields.groups.empty();
    if (plan.byTree)
        rasterPass(context, plan.meshes, depth, spare);
    else if (!fieldsAlone)
        rasterPass(context, plan.meshes, depth, records);
}

void findFields(PassContext& context, const FirstHitPlan& plan, int fieldRoot,
                const DepthImage& depth, const Texture& spare, Texture& records) {
    if (plan.fields.groups.empty()) return;
    if (plan.byTree)
        visibilityFieldsPass(context, fieldRoot, spare, records);
    else
        marchPass(context, plan.fields, depth, plan.meshes.empty(), records);
}

void rasterFirstHits(PassContext& context, std::span<const PackedInstance> instances, int fieldRoot,
                     FieldFinder finder, const DepthImage& depth, Texture& spare,
                     Texture& records) {
    const FirstHitPlan plan = planFirstHits(context, instances, finder);
    rasterMeshes(context, plan, depth, spare, records);
    findFields(context, plan, fieldRoot, depth, spare, records);
}

}  // namespace vitrine
