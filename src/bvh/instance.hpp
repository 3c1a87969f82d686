// SPDX-License-Identifier: MIT
// The two-level structure on the CPU: a tree over instances, each a mesh tree with a transform.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bvh/traverse.hpp"

namespace vitrine {

struct Instance {
    glm::mat4 worldFromObject;  ///< affine and invertible
    uint32_t mesh;
};

/// Borrows: the tree and the arrays must live as long as the view.
struct MeshView {
    const Bvh* bvh;
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

struct SceneHit {
    TriangleHit hit;  ///< t is along the world ray, whose direction need not be normalised
    uint32_t instance;
    bool operator==(const SceneHit&) const = default;
};

/// The box of an instance in the world, widened by some rounding errors so that a ray that is
/// transformed into the object and hits there does not miss this box.
Aabb instanceBox(const Aabb& meshBox, const glm::mat4& worldFromObject);

/// The ray in the object's space; t means the same on both rays.
Ray transformed(const Ray& ray, const glm::mat4& objectFromWorld);

/// The tree over the boxes of the instances; meshes without triangles get a box that no ray meets.
Bvh buildInstanceBvh(std::span<const Instance> instances, std::span<const MeshView> meshes);

std::optional<SceneHit> sceneClosestHit(const Bvh& instanceBvh, std::span<const Instance> instances,
                                        std::span<const MeshView> meshes, const Ray& ray,
                                        TraversalCounters* counters = nullptr);

}  // namespace vitrine
