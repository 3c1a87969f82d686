// SPDX-License-Identifier: MIT
#include "frame/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/error.hpp"
#include "base/text.hpp"
#include "pack/tree_level.hpp"
#include "shared/limits.glsl"

namespace vitrine {

static_assert(static_cast<int>(View::kLoops) == VITRINE_VIEW_LOOPS);
static_assert(static_cast<int>(View::kBvh) == VITRINE_VIEW_BVH);
static_assert(static_cast<int>(View::kThickness) == VITRINE_VIEW_THICKNESS);
static_assert(static_cast<int>(View::kDirect) == VITRINE_VIEW_DIRECT);

const std::vector<std::string>& viewNames() {
    static const std::vector<std::string> names{
        "color",       "albedo",   "normal", "depth",     "instance",   "primitive",
        "barycentric", "material", "direct", "shadow",    "reflection", "ao",
        "steps",       "nodes",    "loops",  "thickness", "bvh"};
    return names;
}

std::optional<View> viewByName(const std::string& name) {
    const auto& names = viewNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    return static_cast<View>(found - names.begin());
}

ViewChoice parseView(const std::string& text) {
    const size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto view = viewByName(name);
    if (!view)
        throw UsageError(fmt::format("--view: there is no view '{}'{}; there are {}", name,
                                     didYouMean(name, viewNames()), fmt::join(viewNames(), ", ")));
    const bool valued = equals != std::string::npos;
    if (*view != View::kBvh) {
        if (valued) throw UsageError(fmt::format("--view: '{}' takes no value", name));
        return {*view, 0};
    }
    int level = -1;
    const std::string digits = valued ? text.substr(equals + 1) : "";
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), level);
    if (error != std::errc() || end != digits.data() + digits.size() || level < 0 ||
        level > kMaxTreeLevel)
        throw UsageError(fmt::format("--view: say which level of the trees, 0 to {}, as in bvh=4",
                                     kMaxTreeLevel));
    return {*view, level};
}

bool showsCounters(View view) {
    return view >= View::kSteps && view <= View::kLoops;
}

bool showsRecords(View view) {
    return view >= View::kAlbedo && view <= View::kMaterial;
}

}  // namespace vitrine
