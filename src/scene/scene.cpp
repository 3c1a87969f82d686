// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

namespace vitrine {
namespace {

glm::mat4 parentFromNode(const Node& node) {
    const glm::vec3 r = glm::radians(node.rotate);
    glm::mat4 m = glm::translate(glm::mat4(1), node.at);
    m = glm::rotate(m, r.z, {0, 0, 1});
    m = glm::rotate(m, r.y, {0, 1, 0});
    m = glm::rotate(m, r.x, {1, 0, 0});
    return glm::scale(m, node.scale);
}

}  // namespace

glm::mat4 worldFromNode(const Scene& scene, size_t index) {
    glm::mat4 result = parentFromNode(scene.nodes[index]);
    const Node* node = &scene.nodes[index];
    // The parser has refused circles; the count guards against scenes made by code.
    for (size_t steps = 0; !node->parent.empty() && steps < scene.nodes.size(); ++steps) {
        const Node* parent = nullptr;
        for (const Node& other : scene.nodes)
            if (other.name == node->parent.name) parent = &other;
        if (parent == nullptr) break;
        result = parentFromNode(*parent) * result;
        node = parent;
    }
    return result;
}

}  // namespace vitrine
