// SPDX-License-Identifier: MIT
// What does not change with time: meshes with their trees, pictures, and the text of the programs.
#pragma once

#include <memory>
#include <vector>

#include "pack/assets.hpp"
#include "pack/generate.hpp"
#include "pack/pack_textures.hpp"

namespace vitrine {

/// Where a mesh lies in the arrays.
struct PackedMesh {
    uint32_t root = 0;  ///< slot
    int firstTriangle = 0;
    /// What a vertex's number is added to for its texel in that list; 0: none.
    int extras = 0, tangents = 0;
};

struct PackedGeometry {
    /// The trees of the meshes. PackedMoment::upperSlots follow them.
    std::vector<glm::uvec4> slots;
    std::vector<glm::uvec4> triangles;
    std::vector<glm::vec4> vertices;
    int meshStack = 0;               ///< most stack entries that a ray needs in any of the trees
    std::vector<PackedMesh> meshes;  ///< one a shape of the scene

    PackedTextures textures;
    std::shared_ptr<const SkyAsset> sky;  ///< null: the gradient in the block

    /// Each file once, in the order of their numbers in the tables (materials count from 1).
    std::vector<std::shared_ptr<const Snippet>> fieldSnippets, materialSnippets;
    GeneratedShaders shaders;
    /// Of any node, visible or not: it may become so.
    bool hasMeshes = false, hasFields = false;
    bool hasVertexExtras = false, hasTangents = false;  ///< some mesh has them
    bool tooLarge = false;  ///< more texels of vertices than an index can name
};

/// The place in such a list of a snippet that is there.
int numberOf(const std::shared_ptr<const Snippet>& snippet,
             const std::vector<std::shared_ptr<const Snippet>>& list);

PackedGeometry packGeometry(const Scene& scene, const Assets& assets);

}  // namespace vitrine
