// SPDX-License-Identifier: MIT
// The numbers behind an animation's target: the same options that the parser reads.
#pragma once

#include <optional>
#include <string_view>

#include "base/text.hpp"
#include "scene/options.hpp"

namespace vitrine {

inline constexpr std::string_view kSetPrefix = "set.";

/// The parameter that "set.PARAMETER" names; nothing for other keys.
inline std::optional<std::string> parameterOf(const std::string& key) {
    if (!startsWith(key, kSetPrefix)) return {};
    return key.substr(kSetPrefix.size());
}

/// Calls `f(options, object)` with the target's object and the table of its options.
template <class S, class F>
auto visitTarget(S& scene, const AnimationTarget& target, F&& f) {
    using Object = AnimationTarget::Object;
    switch (target.object) {
        case Object::kEnvironment:
            return f(environmentOptions(), scene.environment);
        case Object::kCamera:
            return f(cameraOptions(), scene.cameras[target.index]);
        case Object::kLight:
            return f(lightOptions(), scene.lights[target.index]);
        case Object::kMaterial:
            return f(materialOptions(), scene.materials[target.index]);
        case Object::kNode:
            return f(nodeOptions(), scene.nodes[target.index]);
        case Object::kRender:
            break;
    }
    return f(renderOptions(), scene.render);
}

template <class T>
const Option<T>* findOption(const OptionTable<T>& options, std::string_view key) {
    for (const Option<T>& option : options)
        if (option.key == key) return &option;
    return nullptr;
}

/// Truth values jump where numbers go evenly.
template <class T>
bool isTruthValue(const Option<T>& option) {
    return std::holds_alternative<bool T::*>(option.member);
}

/// What can change with time: numbers, vectors, colours and truth values.
template <class T>
bool canChange(const Option<T>& option) {
    return std::holds_alternative<float T::*>(option.member) || isTruthValue(option) ||
           std::holds_alternative<glm::vec3 T::*>(option.member) ||
           std::holds_alternative<Color T::*>(option.member) ||
           std::holds_alternative<ScaleMember<T>>(option.member);
}

template <class T>
glm::vec4 numbersOf(const Option<T>& option, const T& object) {
    if (const auto* number = std::get_if<float T::*>(&option.member))
        return glm::vec4(object.**number, 0, 0, 0);
    if (const auto* flag = std::get_if<bool T::*>(&option.member))
        return glm::vec4(object.**flag ? 1 : 0, 0, 0, 0);
    if (const auto* vector = std::get_if<glm::vec3 T::*>(&option.member))
        return glm::vec4(object.**vector, 0);
    if (const auto* color = std::get_if<Color T::*>(&option.member))
        return glm::vec4((object.**color).rgb, 0);
    return glm::vec4(object.*std::get<ScaleMember<T>>(option.member).member, 0);
}

template <class T>
void setNumbers(const Option<T>& option, T& object, const glm::vec4& value) {
    if (const auto* number = std::get_if<float T::*>(&option.member))
        object.** number = value.x;
    else if (const auto* flag = std::get_if<bool T::*>(&option.member))
        object.** flag = value.x >= 0.5f;
    else if (const auto* vector = std::get_if<glm::vec3 T::*>(&option.member))
        object.** vector = glm::vec3(value);
    else if (const auto* color = std::get_if<Color T::*>(&option.member))
        (object.**color).rgb = glm::vec3(value);
    else
        object.*std::get<ScaleMember<T>>(option.member).member = glm::vec3(value);
}

}  // namespace vitrine
