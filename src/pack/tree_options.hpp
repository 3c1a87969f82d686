// SPDX-License-Identifier: MIT
// What a scene says about its trees, as the builder wants it.
#pragma once

#include "bvh/build.hpp"
#include "scene/scene.hpp"

namespace vitrine {

static_assert(static_cast<int>(TreeBuilder::kNine) == static_cast<int>(BuildMethod::kNine));
static_assert(static_cast<int>(TreeBuilder::kBinned) == static_cast<int>(BuildMethod::kBinned));
static_assert(static_cast<int>(TreeBuilder::kSpatial) == static_cast<int>(BuildMethod::kSpatial));

inline BuildOptions buildOptions(const TreeSettings& settings) {
    BuildOptions options;
    options.method = static_cast<BuildMethod>(settings.builder);
    options.maxLeafSize = settings.maxLeafSize;
    options.traversalCost = settings.traversalCost;
    options.maxDuplicates = settings.maxDuplicates;
    options.minOverlap = settings.minOverlap;
    return options;
}

}  // namespace vitrine
