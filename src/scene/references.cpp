// SPDX-License-Identifier: MIT
#include "scene/references.hpp"

#include <fmt/format.h>

#include <set>
#include <unordered_map>

#include "base/text.hpp"

namespace vitrine {
namespace {

class Names {
  public:
    template <class T>
    explicit Names(const std::vector<T>& objects) {
        for (const T& object : objects)
            if (!object.name.empty()) names_.insert(object.name);
    }

    void check(const Reference& reference, const std::string& what,
               Diagnostics& diagnostics) const {
        if (reference.empty() || names_.count(reference.name) != 0) return;
        // Comparing with every name of a huge scene, error by error, would take minutes.
        constexpr size_t kMostToCompare = 500;
        const std::string hint =
            names_.size() > kMostToCompare
                ? ""
                : didYouMean(reference.name, std::vector(names_.begin(), names_.end()));
        diagnostics.error(reference.where,
                          fmt::format("no {} is named '{}'{}", what, reference.name, hint));
    }

  private:
    std::set<std::string> names_;
};

template <class T>
void checkUnique(const std::vector<T>& objects, const std::string& what, Diagnostics& diagnostics) {
    std::unordered_map<std::string, SourceLocation> seen;
    for (const T& object : objects) {
        if (object.name.empty()) continue;
        const auto [known, isNew] = seen.emplace(object.name, object.where);
        if (!isNew)
            diagnostics.error(object.where,
                              fmt::format("two {}s are named '{}'; the other is at {}", what,
                                          object.name, known->second.text()));
    }
}

/// Walks up from every node until it meets one that an earlier walk has seen.
void checkParents(std::vector<Node>& nodes, Diagnostics& diagnostics) {
    std::unordered_map<std::string, size_t> indexOf;
    for (size_t i = 0; i < nodes.size(); ++i) indexOf[nodes[i].name] = i;
    indexOf.erase("");
    std::vector<size_t> walkOf(nodes.size(), 0);
    for (size_t start = 0; start < nodes.size(); ++start) {
        for (size_t at = start; walkOf[at] == 0;) {
            walkOf[at] = start + 1;
            const auto parent = indexOf.find(nodes[at].parent.name);
            if (parent == indexOf.end()) break;
            if (walkOf[parent->second] == start + 1) {
                diagnostics.error(nodes[at].parent.where,
                                  fmt::format("node '{}' is its own ancestor", nodes[at].name));
                nodes[at].parent = {};
                break;
            }
            at = parent->second;
        }
    }
}

}  // namespace

void checkReferences(Scene& scene, Diagnostics& diagnostics) {
    checkUnique(scene.nodes, "node", diagnostics);
    checkUnique(scene.cameras, "camera", diagnostics);
    checkUnique(scene.lights, "light", diagnostics);
    const Names materials(scene.materials), shapes(scene.shapes), nodes(scene.nodes);
    for (const Node& node : scene.nodes) {
        shapes.check(node.shape, "shape", diagnostics);
        materials.check(node.material, "material", diagnostics);
        nodes.check(node.parent, "node", diagnostics);
        for (const auto& [part, material] : node.parts)
            materials.check(material, "material", diagnostics);
    }
    checkParents(scene.nodes, diagnostics);
}

}  // namespace vitrine
