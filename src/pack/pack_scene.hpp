// SPDX-License-Identifier: MIT
// A scene as flat arrays in the layout that shaders read, and the GLSL it adds. No GL in here.
#pragma once

#include <vector>

#include "base/aabb.hpp"
#include "pack/assets.hpp"
#include "pack/bvh_layout.hpp"
#include "pack/frame_block.hpp"
#include "pack/generate.hpp"
#include "pack/pack_textures.hpp"

namespace vitrine {

struct PackedInstance {
    std::string name;
    glm::mat4 worldFromObject{1};
    Aabb worldBox;
    bool field = false;
    int firstTriangle = 0;  ///< of a mesh, in PackedScene::triangles
    size_t triangles = 0;
};

struct PackedScene {
    std::vector<glm::uvec4> slots;
    std::vector<glm::uvec4> triangles;
    std::vector<glm::vec4> vertices;
    std::vector<glm::vec4> tables;
    GeneratedShaders shaders;
    /// Everything but the camera, the sample and the view.
    FrameBlock block{};
    bool hasMeshes = false, hasFields = false;
    bool hasVertexExtras = false, hasTangents = false;  ///< some mesh has them
    PackedTextures textures;

    std::vector<PackedInstance> instances;
    std::vector<std::string> materialNames;
    Aabb worldBox;
    int fieldRoot = -1;  ///< root slot of a tree over the fields alone; -1 if there are none
    int stackBound = 0;
    size_t triangleCount = 0;  ///< instances counted each
};

/// Errors found on the way (parts without a name, parameters out of range) go to `diagnostics`.
PackedScene packScene(const Scene& scene, const Assets& assets, Diagnostics& diagnostics);

}  // namespace vitrine
