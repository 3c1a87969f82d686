// SPDX-License-Identifier: MIT
#include "scene/pose.hpp"

#include <algorithm>
#include <set>

#include "scene/target.hpp"

namespace vitrine {
namespace {

void setParameter(std::vector<ParameterValue>& set, const std::string& name,
                  const AnimationTrack& track, const glm::vec4& value) {
    auto found = std::find_if(set.begin(), set.end(),
                              [&](const ParameterValue& p) { return p.name == name; });
    if (found == set.end()) {
        set.push_back({name, {}, 1, track.where});
        found = set.end() - 1;
    }
    found->value = value;
    found->components = track.components;
}

void apply(const AnimationTrack& track, double time, Scene& scene) {
    using Object = AnimationTarget::Object;
    const AnimationTarget& target = track.target;
    const glm::vec4 value = sampleTrack(track, time);
    if (target.object == Object::kNode && target.key == kOrientationKey) {
        scene.nodes[target.index].orientation = glm::quat(value.w, value.x, value.y, value.z);
        return;
    }
    if (const auto parameter = parameterOf(target.key)) {
        auto& set = target.object == Object::kNode ? scene.nodes[target.index].set
                                                   : scene.materials[target.index].set;
        return setParameter(set, *parameter, track, value);
    }
    const bool light = target.object == Object::kLight;
    if (light && (target.key == "polar" || target.key == "azimuth"))
        useAngles(scene.lights[target.index]);
    visitTarget(scene, target, [&](const auto& options, auto& object) {
        if (const auto* option = findOption(options, target.key))
            setNumbers(*option, object, value);
    });
    // Whichever of the two moves is the one that counts.
    if (light && target.key == "direction") scene.lights[target.index].polar = Light::kNoAngle;
    if (target.object == Object::kCamera && target.key == "fov")
        scene.cameras[target.index].focalLength = 0;
    if (target.object == Object::kCamera && target.key == "focal_length")
        scene.cameras[target.index].fov = 0;
}

void hideWhatHasNoSize(Scene& scene) {
    constexpr float kNothing = 1e-12f;  // its inverse would leave the range of numbers
    std::set<std::string> hidden;
    for (Node& node : scene.nodes) {
        const glm::vec3 size = glm::abs(node.scale);
        if (std::min({size.x, size.y, size.z}) >= kNothing) continue;
        node.scale = glm::vec3(1);
        node.visible = false;
        if (!node.name.empty()) hidden.insert(node.name);
    }
    // Parents may come after their children: until nothing new is found.
    for (size_t before = 0; before != hidden.size();) {
        before = hidden.size();
        for (Node& node : scene.nodes) {
            if (hidden.count(node.parent.name) == 0) continue;
            node.visible = false;
            if (!node.name.empty()) hidden.insert(node.name);
        }
    }
}

}  // namespace

Scene poseScene(const Scene& scene, double time) {
    Scene posed = scene;
    for (const AnimationTrack& track : scene.animations) apply(track, time, posed);
    for (size_t i = 0; i < posed.cameras.size(); ++i)
        if (!problemOf(posed.cameras[i]).empty()) posed.cameras[i] = scene.cameras[i];
    for (size_t i = 0; i < posed.lights.size(); ++i) {
        Light& light = posed.lights[i];
        if (glm::length(light.direction) < 1e-6f) light.direction = scene.lights[i].direction;
        light.innerAngle = std::min(light.innerAngle, light.outerAngle);
    }
    hideWhatHasNoSize(posed);
    return posed;
}

}  // namespace vitrine
