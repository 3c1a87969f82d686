// SPDX-License-Identifier: MIT
// The best plane to cut the triangles of a node in two, and the cut. Private to the builders.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "bvh/clip.hpp"
#include "bvh/split.hpp"

namespace vitrine {

using References = std::vector<Reference>;

inline Aabb aabbOf(const Box4& box) {
    return {toVec3(box.min), toVec3(box.max)};
}

/// Half of the area, in double: the squares of huge coordinates do not fit a float.
double areaOf(const Aabb& box);

/// References that one side of a cut gets, and their box.
struct Side {
    References references;
    Aabb box;

    void add(const Reference& reference) {
        references.push_back(reference);
        box.grow(aabbOf(reference.box()));
    }
};

/// Axis -1: nowhere.
struct PlaneCut {
    double cost = std::numeric_limits<double>::infinity();  ///< area times references of the sides
    int axis = -1;
    float plane = 0;
    Aabb left, right;
    size_t leftCount = 0, rightCount = 0;
};

class PlaneCutter {
  public:
    /// Borrows both. `bins`: up to so many slabs of the node's box are told apart along each axis.
    PlaneCutter(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                int bins);

    /// The cheapest plane between the bins of `box`, which holds all references.
    [[nodiscard]] PlaneCut best(const References& references, const Aabb& box) const;
    /// Gives each side what lies there, or the whole reference where cutting costs more than it
    /// gains.
    void cut(const PlaneCut& cut, const References& references, Side& left, Side& right) const;

  private:
    [[nodiscard]] Corners cornersOf(uint32_t triangle) const {
        const glm::uvec3& t = triangles_[triangle];
        return {positions_[t.x], positions_[t.y], positions_[t.z]};
    }
    template <class Bins>
    void fill(Bins& bins, const Reference& reference) const;

    std::span<const glm::vec3> positions_;
    std::span<const glm::uvec3> triangles_;
    std::vector<bool> clippable_;
    int bins_;
};

}  // namespace vitrine
