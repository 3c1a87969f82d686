// SPDX-License-Identifier: MIT
#include "scene/references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "base/text.hpp"

namespace vitrine {
namespace {

/// Which references a check is about.
enum class Which { kAll, kOfScene, kOfModels };

bool isAbout(Which which, const Reference& reference) {
    if (which == Which::kAll) return true;
    const bool late =
        reference.name.find('/') != std::string::npos || startsWith(reference.where.file, "--set ");
    return late == (which == Which::kOfModels);
}

class Names {
  public:
    template <class T>
    Names(const std::vector<T>& objects, Which which) : which_(which) {
        for (const T& object : objects)
            if (!object.name.empty()) names_.insert(object.name);
    }

    void check(const Reference& reference, const std::string& what,
               Diagnostics& diagnostics) const {
        if (reference.empty() || !isAbout(which_, reference)) return;
        if (names_.count(reference.name) != 0) return;
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
    Which which_;
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

void checkNames(Scene& scene, Which which, Diagnostics& diagnostics) {
    const Names materials(scene.materials, which), shapes(scene.shapes, which),
        nodes(scene.nodes, which);
    for (const Node& node : scene.nodes) {
        shapes.check(node.shape, "shape", diagnostics);
        materials.check(node.material, "material", diagnostics);
        nodes.check(node.parent, "node", diagnostics);
        for (const auto& [part, material] : node.parts)
            materials.check(material, "material", diagnostics);
    }
    checkParents(scene.nodes, diagnostics);
}

}  // namespace

void checkReferences(Scene& scene, Diagnostics& diagnostics) {
    checkUnique(scene.nodes, "node", diagnostics);
    checkUnique(scene.cameras, "camera", diagnostics);
    checkUnique(scene.lights, "light", diagnostics);
    checkNames(scene, importsModels(scene) ? Which::kOfScene : Which::kAll, diagnostics);
}

void checkImportedReferences(Scene& scene, Diagnostics& diagnostics) {
    if (importsModels(scene)) checkNames(scene, Which::kOfModels, diagnostics);
}

bool isModelFile(std::string_view name) {
    return endsWith(name, ".gltf") || endsWith(name, ".glb");
}

bool importsModels(const Scene& scene) {
    return std::any_of(scene.nodes.begin(), scene.nodes.end(),
                       [](const Node& n) { return !n.include.empty(); }) ||
           std::any_of(scene.shapes.begin(), scene.shapes.end(),
                       [](const Shape& s) { return isModelFile(s.mesh.name); });
}

}  // namespace vitrine
