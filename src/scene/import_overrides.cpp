// SPDX-License-Identifier: MIT
#include "scene/import_overrides.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "scene/values.hpp"

namespace vitrine {
namespace {

struct ImportKey {
    std::string section, name, key;
};

/// Nothing if the assignment has not the form SECTION.MODEL/NAME.KEY=VALUE.
std::optional<ImportKey> splitImportKey(const std::string& assignment) {
    const std::string_view key = std::string_view(assignment).substr(0, assignment.find('='));
    const size_t first = key.find('.'), last = key.rfind('.');
    if (first == last) return {};  // one dot, or none
    const std::string_view name = trim(key.substr(first + 1, last - first - 1));
    if (name.find('/') == std::string_view::npos) return {};
    return ImportKey{std::string(trim(key.substr(0, first))), std::string(name),
                     std::string(trim(key.substr(last + 1)))};
}

/// `name`, or a key below it.
bool means(std::string_view name, std::string_view declared) {
    return !declared.empty() && startsWith(name, declared) &&
           (name.size() == declared.size() || name[declared.size()] == '.');
}

/// What an option may not become, although it is in its range; "" if nothing.
std::string problemOf(const Material&, const Material&) {
    return "";
}
std::string problemOf(const Light& light, const Light& before) {
    if (light.polar < 0 && light.azimuth != before.azimuth)
        return "azimuth needs polar, the angle from the zenith";
    if (glm::length(light.direction) < 1e-6f) return "direction has no length";
    if (light.innerAngle > light.outerAngle) return "inner_angle is larger than outer_angle";
    return "";
}
std::string problemOf(const Node& node, const Node& before) {
    if (node.scale != before.scale && glm::any(glm::equal(node.scale, glm::vec3(0))))
        return "scale must not be zero";
    if (node.name != before.name) return "the name is the file's";
    if (node.include.name != before.include.name || node.animation.name != before.animation.name)
        return "an include and its animation stand in a scene file only";
    return "";
}

template <class T>
void assign(std::vector<T>& objects, const ImportKey& at, const OptionTable<T>& options,
            const std::string& assignment, Diagnostics& diagnostics) {
    const SourceLocation where{"--set " + assignment};
    const auto found = std::find_if(objects.begin(), objects.end(),
                                    [&](const T& object) { return object.name == at.name; });
    if (found == objects.end()) {
        // Comparing with every name of a huge model would take minutes.
        constexpr size_t kMostToCompare = 500;
        std::vector<std::string> names;
        if (objects.size() <= kMostToCompare)
            for (const T& object : objects) names.push_back(object.name);
        diagnostics.error(where, fmt::format("the scene has no {} '{}'{}", at.section, at.name,
                                             didYouMean(at.name, names)));
        return;
    }
    auto value = parseValue(assignment.substr(assignment.find('=') + 1), where.file);
    if (!value) {
        diagnostics.error(where, "the value is not understood");
        return;
    }
    toml::table table;
    // Moved, because a copy would forget where it came from.
    (*value)["value"].visit([&](auto& node) { table.insert(at.key, std::move(node)); });
    const T before = *found;
    readTable(table, fmt::format("[{}.{}]", at.section, at.name), options, {}, *found, diagnostics);
    if constexpr (std::is_same_v<T, Node>)
        if (at.key == "rotate") found->orientation.reset();
    if constexpr (std::is_same_v<T, Light>)
        if (at.key == "at" || at.key == "direction") found->node.reset();
    const std::string problem = problemOf(*found, before);
    if (!problem.empty()) diagnostics.error(where, problem);
}

/// What is given is not animated.
void stop(Scene& scene, const ImportKey& at) {
    const std::string key = at.key == "rotate" ? kOrientationKey : at.key;
    std::erase_if(scene.animations, [&](const AnimationTrack& track) {
        return track.target.object == AnimationTarget::Object::kNode && track.target.key == key &&
               scene.nodes[track.target.index].name == at.name;
    });
}

}  // namespace

bool namesImported(const toml::table& document, const std::string& assignment) {
    const auto at = splitImportKey(assignment);
    if (!at) return false;
    const toml::node* section = document.get(at->section);
    if (section == nullptr) return true;
    if (const toml::table* group = section->as_table())
        for (const auto& [key, value] : *group)
            if (means(at->name, key.str())) return false;
    if (const toml::array* list = section->as_array())
        for (const toml::node& entry : *list)
            if (const toml::table* table = entry.as_table())
                if (means(at->name, (*table)["name"].value_or(std::string()))) return false;
    return true;
}

void applyImportOverride(Scene& scene, const std::string& assignment, Diagnostics& diagnostics) {
    const auto at = splitImportKey(assignment);
    const SourceLocation where{"--set " + assignment};
    if (!at || assignment.find('=') == std::string::npos)
        diagnostics.error(where, "write it as section.NAME.key=value");
    else if (at->section == "material")
        assign(scene.materials, *at, materialOptions(), assignment, diagnostics);
    else if (at->section == "node") {
        assign(scene.nodes, *at, nodeOptions(), assignment, diagnostics);
        stop(scene, *at);
    } else if (at->section == "light")
        assign(scene.lights, *at, lightOptions(), assignment, diagnostics);
    else
        diagnostics.error(where, fmt::format("of a model, only materials, nodes and lights can be "
                                             "set, not '{}'",
                                             at->section));
}

}  // namespace vitrine
