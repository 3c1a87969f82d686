// SPDX-License-Identifier: MIT
#include "app/viewer/node_tree.hpp"

#include <unordered_map>

#include "base/text.hpp"

namespace vitrine {

NodeTree::NodeTree(const Scene& scene)
    : parents_(scene.nodes.size()), children_(scene.nodes.size()) {
    std::unordered_map<std::string_view, size_t> indexOf;
    for (size_t i = 0; i < scene.nodes.size(); ++i) indexOf[scene.nodes[i].name] = i;
    indexOf.erase("");
    for (size_t i = 0; i < scene.nodes.size(); ++i) {
        const auto found = indexOf.find(scene.nodes[i].parent.name);
        if (found == indexOf.end()) {
            roots_.push_back(i);
        } else {
            parents_[i] = found->second;
            children_[found->second].push_back(i);
        }
    }
}

bool NodeTree::isWithin(size_t node, size_t ancestor) const {
    // The parser has refused circles.
    for (std::optional<size_t> at = node; at; at = parents_[*at])
        if (*at == ancestor) return true;
    return false;
}

std::string shortName(const Scene& scene, const NodeTree& tree, size_t node) {
    const std::string& name = scene.nodes[node].name;
    for (auto up = tree.parent(node); up; up = tree.parent(*up)) {
        const std::string prefix = scene.nodes[*up].name + '/';
        if (startsWith(name, prefix)) return name.substr(prefix.size());
    }
    return name;
}

}  // namespace vitrine
