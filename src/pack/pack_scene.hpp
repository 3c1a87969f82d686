// SPDX-License-Identifier: MIT
// A scene as flat arrays in the layout that shaders read, and the GLSL it adds. No GL in here.
// Meshes and textures are packed once; what moves is packed again for every moment.
#pragma once

#include <vector>

#include "base/aabb.hpp"
#include "pack/assets.hpp"
#include "pack/bvh_layout.hpp"
#include "pack/frame_block.hpp"
#include "pack/pack_geometry.hpp"

namespace vitrine {

struct PackedInstance {
    std::string name;
    size_t node = 0;  ///< in Scene::nodes
    glm::mat4 worldFromObject{1};
    Aabb worldBox;
    bool field = false;
    int firstTriangle = 0;  ///< of a mesh, in PackedScene::triangles
    size_t triangles = 0;
    Aabb objectBox;                         ///< of the mesh, or the bounds of the field
    std::shared_ptr<const MeshAsset> mesh;  ///< null: a field
    bool culled = false;                    ///< not seen from behind
    bool filtered = false;                  ///< rays pass parts of it: holes, veils, glass
    int snippet = 0;                        ///< of a field, in PackedScene::fieldSnippets
};

/// What changes with time, and what a hand on a slider changes: all that is cheap to make again.
struct PackedMoment {
    /// The trees over the instances; addresses count on from PackedGeometry::slots.
    std::vector<glm::uvec4> upperSlots;
    std::vector<glm::vec4> tables;
    /// Everything but the camera, the sample and the view.
    FrameBlock block{};
    bool hasLayers = false;        ///< materials with varnish or sheen
    bool hasTransmission = false;  ///< materials that light passes
    bool hasSubsurface = false;    ///< materials that light comes through, scattered
    bool hasClassic = false;       ///< materials that are lambert or blinn-phong
    bool hasCurvature = false;     ///< snippets that ask for it
    bool hasFilters = false;       ///< instances that let rays pass: holes, veils, glass
    bool hasCulling = false;       ///< meshes that are not seen from behind
    bool hasCones = false;         ///< shadow rays mind what they pass (shaders/trace/cone.glsl)

    std::vector<PackedInstance> instances;
    std::vector<std::string> materialNames;
    Aabb worldBox;
    int fieldRoot = -1;  ///< root slot of a tree over the fields alone; -1 if there are none
    int stackBound = 0;
    size_t triangleCount = 0;  ///< instances counted each
};

struct PackedScene : PackedGeometry, PackedMoment {};

/// Errors found on the way (parts without a name, parameters out of range) go to `diagnostics`.
PackedScene packScene(const Scene& scene, const Assets& assets, Diagnostics& diagnostics);

/// The same scene again, after its animations (pose.hpp) or its user have changed nodes, materials,
/// lights or settings. `geometry` was packed for the same shapes, textures and snippets.
PackedMoment packMoment(const Scene& scene, const Assets& assets, const PackedGeometry& geometry,
                        Diagnostics& diagnostics);

}  // namespace vitrine
