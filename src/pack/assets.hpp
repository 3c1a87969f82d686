// SPDX-License-Identifier: MIT
// What a scene refers to, read from disk and ready to be packed: meshes with their trees, and
// snippets. Kept apart from the scene so that a reload reads only what has changed.
#pragma once

#include <memory>
#include <vector>

#include "base/reuse.hpp"
#include "bvh/bvh.hpp"
#include "mesh/mesh.hpp"
#include "pack/sky_map.hpp"
#include "scene/scene.hpp"
#include "sdf/snippet.hpp"
#include "shared/limits.glsl"

namespace vitrine {

struct MeshAsset {
    std::shared_ptr<const Mesh> mesh;  ///< never null
    Bvh bvh;
    double buildSeconds = 0;
};

/// The picture around the scene, and the sun that a computed one has.
struct SkyAsset {
    SkyMap map;
    struct Sun {
        glm::vec3 irradiance{0};  ///< on a surface that faces it
        float radius = 0;         ///< degrees
    };
    std::optional<Sun> sun;  ///< stands over the middle of the picture, at the scene's elevation
};

/// One entry a shape or material of the scene, in its order; null where there is none or where
/// reading failed, with a diagnostic.
struct Assets {
    std::vector<std::shared_ptr<const MeshAsset>> meshes;
    std::vector<std::shared_ptr<const Snippet>> fields;
    std::vector<std::shared_ptr<const Snippet>> materials;
    /// The pictures of each material's textures, in the order of materialTextures().
    std::vector<std::vector<std::shared_ptr<const ImageRgba8>>> pictures;
    std::shared_ptr<const SkyAsset> sky;  ///< null: the gradient, or reading failed
};

/// The textures of a material in the order of VITRINE_SLOT_*.
std::array<const MaterialTexture*, VITRINE_SLOT_COUNT> materialTextures(const Material& material);

/// What has been read and built for a scene, for the next load of it.
struct AssetCache {
    Reuse<MeshAsset> trees;
    Reuse<ImageRgba8> pictures;
    Reuse<SkyAsset> skies;
    /// A scene has been loaded: forgets what it did not need.
    void sweep() {
        trees.sweep();
        pictures.sweep();
        skies.sweep();
    }
};

/// Reads everything the scene names. Files must lie in the scene's folder or below. Fields may lack
/// bounds, which packing needs (app/session/field_prober.hpp finds them).
Assets loadAssets(const Scene& scene, Diagnostics& diagnostics);
/// The same, but takes from the cache what has not changed.
Assets loadAssets(const Scene& scene, AssetCache& cache, Diagnostics& diagnostics);

}  // namespace vitrine
