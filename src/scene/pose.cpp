// SPDX-License-Identifier: MIT
#include "scene/pose.hpp"

#include <algorithm>
#include <cmath>

#include "scene/place.hpp"
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
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(value[i])) return;  // a spline between far values
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

/// Not flattened, but moved or scaled out of all bounds: a mistake, of which pack/ tells.
bool isTooFar(const glm::mat4& world) {
    for (int column = 0; column < 4; ++column)
        if (!(glm::length(glm::vec3(world[column])) <= 1e18f)) return true;
    return false;
}

/// Cameras, lights and visibility of what stands on nodes that move.
void applyPlaces(const Scene& rest, Scene& posed) {
    const std::vector<bool> moved = movedNodes(rest);
    if (std::find(moved.begin(), moved.end(), true) == moved.end()) return;
    const std::vector<glm::mat4> world = worldFromNodes(posed);
    for (Camera& camera : posed.cameras)
        if (camera.node && moved[*camera.node] && isUsablePlace(world[*camera.node]))
            placeOn(world[*camera.node], camera);
    for (Light& light : posed.lights) {
        if (!light.node || !moved[*light.node]) continue;
        if (isUsablePlace(world[*light.node]))
            placeOn(world[*light.node], light);
        else
            light.intensity = 0;
    }
    for (size_t i = 0; i < posed.nodes.size(); ++i)
        if (moved[i] && !isUsablePlace(world[i]) && !isTooFar(world[i]))
            posed.nodes[i].visible = false;
}

}  // namespace

Scene poseScene(const Scene& scene, double time) {
    Scene posed = scene;
    for (const AnimationTrack& track : scene.animations) apply(track, time, posed);
    applyPlaces(scene, posed);
    for (size_t i = 0; i < posed.cameras.size(); ++i)
        if (!problemOf(posed.cameras[i]).empty()) posed.cameras[i] = scene.cameras[i];
    for (size_t i = 0; i < posed.lights.size(); ++i) {
        Light& light = posed.lights[i];
        if (glm::length(light.direction) < 1e-6f) light.direction = scene.lights[i].direction;
        light.innerAngle = std::min(light.innerAngle, light.outerAngle);
    }
    return posed;
}

std::vector<bool> movedNodes(const Scene& scene) {
    std::vector<bool> moved(scene.nodes.size(), false);
    for (const AnimationTrack& track : scene.animations)
        if (track.target.object == AnimationTarget::Object::kNode) moved[track.target.index] = true;
    for (const auto& [node, parent] : nodesParentsFirst(scene))
        if (parent && moved[*parent]) moved[node] = true;
    return moved;
}

}  // namespace vitrine
