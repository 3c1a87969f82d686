// SPDX-License-Identifier: MIT
// The textures of all materials: pages of texels, and the tables by which shaders find them
// (shaders/scene/texture.glsl, shaders/shade/textures.glsl).
#pragma once

#include <span>
#include <vector>

#include "pack/assets.hpp"
#include "pack/texture_atlas.hpp"

namespace vitrine {

struct PackedTextures {
    TextureAtlas color, data;
    /// Begins at texel 0 of the scene's tables, so that its own addresses hold.
    std::vector<glm::vec4> table;
    struct Slots {
        int first = 0, count = 0;  ///< in `table`
    };
    std::vector<Slots> slots;  ///< one a material
    [[nodiscard]] bool any() const { return !color.pages.empty() || !data.pages.empty(); }
};

PackedTextures packMaterialTextures(const Scene& scene, const Assets& assets);

/// Into a copy of the table: how strongly textures work, which may change with time.
void writeStrengths(const Scene& scene, const PackedTextures& textures, std::span<glm::vec4> table);

}  // namespace vitrine
