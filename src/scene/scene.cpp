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

std::vector<glm::mat4> worldFromNodes(const Scene& scene) {
    std::unordered_map<std::string, size_t> indexOf;
    for (size_t i = 0; i < scene.nodes.size(); ++i) indexOf[scene.nodes[i].name] = i;
    indexOf.erase("");
    std::vector<glm::mat4> world(scene.nodes.size(), glm::mat4(1));
    std::vector<bool> visited(scene.nodes.size(), false);
    for (size_t start = 0; start < scene.nodes.size(); ++start) {
        // Up to the first ancestor that is known, then down again. The parser has refused circles;
        // in a scene made by code a circle ends where it closes.
        std::vector<size_t> chain;
        glm::mat4 m(1);
        for (size_t at = start;;) {
            if (visited[at]) {
                m = world[at];
                break;
            }
            visited[at] = true;
            chain.push_back(at);
            const auto parent = indexOf.find(scene.nodes[at].parent.name);
            if (parent == indexOf.end()) break;
            at = parent->second;
        }
        for (size_t i = chain.size(); i-- > 0;)
            world[chain[i]] = m = m * parentFromNode(scene.nodes[chain[i]]);
    }
    return world;
}

std::vector<bool> visibleNodes(const Scene& scene) {
    std::vector<bool> visible(scene.nodes.size());
    for (size_t i = 0; i < visible.size(); ++i) visible[i] = scene.nodes[i].visible;
    if (std::find(visible.begin(), visible.end(), false) == visible.end()) return visible;
    std::unordered_map<std::string, size_t> indexOf;
    for (size_t i = 0; i < scene.nodes.size(); ++i) indexOf[scene.nodes[i].name] = i;
    indexOf.erase("");
    std::vector<bool> visited(scene.nodes.size(), false);
    std::vector<size_t> chain;
    for (size_t start = 0; start < scene.nodes.size(); ++start) {
        chain.clear();
        bool shown = true;
        for (size_t at = start;;) {
            if (visited[at]) {
                shown = visible[at];
                break;
            }
            visited[at] = true;
            chain.push_back(at);
            const auto parent = indexOf.find(scene.nodes[at].parent.name);
            if (parent == indexOf.end()) break;
            at = parent->second;
        }
        for (size_t i = chain.size(); i-- > 0;)
            visible[chain[i]] = shown = shown && visible[chain[i]];
    }
    return visible;
}

}  // namespace vitrine
