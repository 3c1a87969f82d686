// SPDX-License-Identifier: MIT
#include "frame/view.hpp"

#include <algorithm>

#include "shared/limits.glsl"

namespace vitrine {

static_assert(static_cast<int>(View::kLoops) == VITRINE_VIEW_LOOPS);
static_assert(static_cast<int>(View::kDirect) == VITRINE_VIEW_DIRECT);

const std::vector<std::string>& viewNames() {
    static const std::vector<std::string> names{
        "color",    "albedo", "normal", "depth",      "instance", "primitive", "barycentric",
        "material", "direct", "shadow", "reflection", "steps",    "nodes",     "loops"};
    return names;
}

std::optional<View> viewByName(const std::string& name) {
    const auto& names = viewNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    return static_cast<View>(found - names.begin());
}

bool showsCounters(View view) {
    return view >= View::kSteps;
}

bool showsRecords(View view) {
    return view >= View::kAlbedo && view <= View::kMaterial;
}

}  // namespace vitrine
