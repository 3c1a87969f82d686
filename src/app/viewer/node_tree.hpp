// SPDX-License-Identifier: MIT
// What hangs on what: the nodes of a scene as a tree.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace vitrine {

class NodeTree {
  public:
    explicit NodeTree(const Scene& scene);

    [[nodiscard]] const std::vector<size_t>& roots() const { return roots_; }
    [[nodiscard]] const std::vector<size_t>& children(size_t node) const { return children_[node]; }
    [[nodiscard]] std::optional<size_t> parent(size_t node) const { return parents_[node]; }
    /// Whether it is `ancestor` or stands below it.
    [[nodiscard]] bool isWithin(size_t node, size_t ancestor) const;

  private:
    std::vector<std::optional<size_t>> parents_;
    std::vector<std::vector<size_t>> children_;
    std::vector<size_t> roots_;
};

/// A node's name without what its parent's name says already: "car/wheel" below "car" is "wheel".
std::string shortName(const Scene& scene, const NodeTree& tree, size_t node);

}  // namespace vitrine
