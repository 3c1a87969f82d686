// SPDX-License-Identifier: MIT
// The trees as the shader reads them: slots of three RGBA32UI texels (shaders/trace/node.glsl).
//
// A slot is a four-wide node with boxes quantised to 8 bits, a triangle, or the name of an
// instance. The children of a node lie side by side, so that a node needs one address and four
// bytes for all of them. 48 bytes a node, against 112 of a node with float boxes; see
// docs/performance.md for what that gains.
#pragma once

#include <span>
#include <vector>

#include "bvh/bvh.hpp"

namespace vitrine {

class BvhLayout {
  public:
    /// The first slot's address: the number of slots that lie before these.
    explicit BvhLayout(uint32_t firstSlot = 0) : firstSlot_(firstSlot) {}

    /// Appends the tree of a mesh. Returns its root slot.
    uint32_t addMesh(const Bvh& bvh, std::span<const glm::vec3> positions,
                     std::span<const glm::uvec3> triangles);
    /// Appends an upper level; `instances` are the numbers of the tree's items. Returns its root
    /// slot.
    uint32_t addInstances(const Bvh& bvh, std::span<const uint32_t> instances);

    [[nodiscard]] const std::vector<glm::uvec4>& texels() const { return texels_; }
    /// Most stack entries that a ray can need, both levels together.
    [[nodiscard]] int stackBound() const { return instanceStack_ + meshStack_; }
    void clear();

  private:
    template <class WriteItem>
    uint32_t add(const Bvh& bvh, int& stackBound, const WriteItem& writeItem);

    uint32_t firstSlot_;
    std::vector<glm::uvec4> texels_;
    int meshStack_ = 0, instanceStack_ = 0;
};

/// A node's boxes in 8 bits a plane.
struct QuantisedNode {
    glm::vec3 origin;
    glm::uvec3 exponents;  ///< of the grid's step, biased by 127 as in a float
    glm::uvec3 low, high;  ///< by axis; one byte a child
};

/// Every quantised box contains its original. Boxes must be finite.
QuantisedNode quantise(std::span<const Aabb> children);
/// The box that the shader sees for a child.
Aabb dequantise(const QuantisedNode& node, int child);

}  // namespace vitrine
