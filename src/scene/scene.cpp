// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace vitrine {
namespace {

glm::mat4 parentFromNode(const Node& node) {
    glm::mat4 m = glm::translate(glm::mat4(1), node.at);
    if (node.orientation) {
        m = m * glm::mat4_cast(*node.orientation);
    } else {
        const glm::vec3 r = glm::radians(node.rotate);
        m = glm::rotate(m, r.z, {0, 0, 1});
        m = glm::rotate(m, r.y, {0, 1, 0});
        m = glm::rotate(m, r.x, {1, 0, 0});
    }
    m = glm::scale(m, node.scale);
    return node.matrix ? m * *node.matrix : m;
}

}  // namespace

std::string problemOf(const Camera& camera) {
    const glm::vec3 forward = camera.target - camera.eye;
    if (glm::length(forward) < 1e-6f) return "the camera's eye and target are the same point";
    if (glm::length(camera.up) < 1e-6f) return "up has no length";
    if (glm::length(glm::cross(glm::normalize(forward), glm::normalize(camera.up))) < 1e-6f)
        return "the camera looks along its up direction";
    return "";
}

glm::vec3 travelOf(const Light& light) {
    if (light.polar < 0) return glm::normalize(light.direction);
    const float polar = glm::radians(light.polar), azimuth = glm::radians(light.azimuth);
    return -glm::vec3(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                      std::sin(polar) * std::cos(azimuth));
}

void useAngles(Light& light) {
    if (light.polar >= 0) return;
    const glm::vec3 from = -glm::normalize(light.direction);
    light.polar = glm::degrees(std::acos(glm::clamp(from.y, -1.0f, 1.0f)));
    light.azimuth = glm::degrees(std::atan2(from.x, from.z));
}

std::vector<NodeAndParent> nodesParentsFirst(const Scene& scene) {
    std::unordered_map<std::string, size_t> indexOf;
    for (size_t i = 0; i < scene.nodes.size(); ++i) indexOf[scene.nodes[i].name] = i;
    indexOf.erase("");
    std::vector<NodeAndParent> ordered;
    ordered.reserve(scene.nodes.size());
    std::vector<bool> visited(scene.nodes.size(), false);
    for (size_t start = 0; start < scene.nodes.size(); ++start) {
        // Up to the first ancestor that is in order or asked about already, then turned over.
        const auto chain = static_cast<ptrdiff_t>(ordered.size());
        for (size_t at = start; !visited[at];) {
            visited[at] = true;
            const auto parent = indexOf.find(scene.nodes[at].parent.name);
            const bool has = parent != indexOf.end();
            ordered.push_back({at, has ? std::optional(parent->second) : std::nullopt});
            if (has) at = parent->second;
        }
        std::reverse(ordered.begin() + chain, ordered.end());
        // The parser has refused circles; in a scene made by code a circle ends where it closes.
        if (const auto first = ordered.begin() + chain; first != ordered.end() && first->parent) {
            const auto inChain = [&](const NodeAndParent& n) { return n.node == *first->parent; };
            if (std::any_of(first, ordered.end(), inChain)) first->parent.reset();
        }
    }
    return ordered;
}

std::vector<glm::mat4> worldFromNodes(const Scene& scene) {
    std::vector<glm::mat4> world(scene.nodes.size());
    for (const auto& [node, parent] : nodesParentsFirst(scene)) {
        world[node] = parentFromNode(scene.nodes[node]);
        if (parent) world[node] = world[*parent] * world[node];
    }
    return world;
}

std::vector<bool> visibleNodes(const Scene& scene) {
    std::vector<bool> visible(scene.nodes.size());
    const auto isVisible = [](const Node& node) { return node.visible; };
    std::transform(scene.nodes.begin(), scene.nodes.end(), visible.begin(), isVisible);
    if (std::find(visible.begin(), visible.end(), false) == visible.end()) return visible;
    for (const auto& [node, parent] : nodesParentsFirst(scene))
        if (parent && !visible[*parent]) visible[node] = false;
    return visible;
}

}  // namespace vitrine
