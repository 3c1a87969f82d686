// SPDX-License-Identifier: MIT
// What a picture shows: the finished light, or one stage on the way to it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// In the order of VITRINE_VIEW_* (shaders/shared/limits.glsl).
enum class View {
    kColor,
    kAlbedo,
    kNormal,
    kDepth,
    kInstance,
    kPrimitive,
    kBarycentric,
    kMaterial,
    kDirect,
    kShadow,
    kReflection,
    kAo,
    kSteps,
    kNodes,
    kLoops,
    kThickness,
    kBvh,
};

/// The names for `--view`, in the order of the enumeration.
const std::vector<std::string>& viewNames();
std::optional<View> viewByName(const std::string& name);

/// Shows numbers of the counters, so that the passes must count.
bool showsCounters(View view);
/// Shows the first hit; light is not needed.
bool showsRecords(View view);

/// A view and the level of the trees that kBvh shows.
struct ViewChoice {
    View view = View::kColor;
    int treeLevel = 0;
};
/// "normal", or "bvh=4". Throws UsageError, with what there is.
ViewChoice parseView(const std::string& text);

}  // namespace vitrine
