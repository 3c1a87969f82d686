// SPDX-License-Identifier: MIT
#include "pack/pack_textures.hpp"

#include <algorithm>
#include <tuple>

#include "shared/limits.glsl"

namespace vitrine {
namespace {

constexpr auto kUses = [] {
    std::array<TextureUse, VITRINE_SLOT_COUNT> uses{};
    uses.fill(TextureUse::kData);
    for (const int slot : {VITRINE_SLOT_BASE_COLOR, VITRINE_SLOT_EMISSION,
                           VITRINE_SLOT_SPECULAR_COLOR, VITRINE_SLOT_SHEEN_COLOR})
        uses[static_cast<size_t>(slot)] = TextureUse::kColor;
    return uses;
}();

/// Pictures to be packed, each once for every way it is wrapped and filtered.
class RequestList {
  public:
    int add(const ImageRgba8* image, const MaterialTexture& texture) {
        for (size_t i = 0; i < list.size(); ++i)
            if (std::tie(list[i].image, list[i].wrapU, list[i].wrapV, list[i].nearest) ==
                std::tie(image, texture.wrapU, texture.wrapV, texture.nearest))
                return static_cast<int>(i);
        list.push_back({image, texture.wrapU, texture.wrapV, texture.nearest});
        return static_cast<int>(list.size()) - 1;
    }
    std::vector<TextureRequest> list;
};

/// Of one use of a picture by a material, in the table.
constexpr int kUseTexels = 3;

template <class... T>
glm::vec4 texel(T... values) {
    return {static_cast<float>(values)...};
}

/// An entry for each picture, then its levels. Returns the addresses of the entries.
std::vector<int> appendEntries(const TextureAtlas& atlas, std::vector<glm::vec4>& table) {
    std::vector<int> addresses;
    for (const TexturePlace& place : atlas.places) {
        const auto entry = static_cast<int>(table.size());
        addresses.push_back(entry);
        table.push_back(texel(place.log2Width | place.log2Height << 5, entry + 1,
                              place.levels.size(),
                              static_cast<int>(place.wrapU) | static_cast<int>(place.wrapV) << 2 |
                                  (place.nearest ? 16 : 0)));
        for (const LevelPlace& level : place.levels)
            table.push_back(texel(level.page, level.x, level.y, 0));
    }
    return addresses;
}

float strengthOf(const Material& m, int slot) {
    if (slot == VITRINE_SLOT_NORMAL) return m.normalScale;
    if (slot == VITRINE_SLOT_CLEARCOAT_NORMAL) return m.clearcoatNormalScale;
    if (slot == VITRINE_SLOT_OCCLUSION) return m.occlusionStrength;
    return 1;
}

}  // namespace

PackedTextures packMaterialTextures(const Scene& scene, const Assets& assets) {
    PackedTextures packed;
    struct Use {
        int slot, request;
    };
    std::array<RequestList, 2> requests;
    std::vector<std::vector<Use>> uses(scene.materials.size());
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const auto textures = materialTextures(scene.materials[i]);
        for (size_t k = 0; k < textures.size(); ++k)
            if (const auto& picture = assets.pictures[i][k])
                uses[i].push_back({static_cast<int>(k), requests[static_cast<size_t>(kUses[k])].add(
                                                            picture.get(), *textures[k])});
    }
    packed.color = packTextures(requests[0].list, TextureUse::kColor);
    packed.data = packTextures(requests[1].list, TextureUse::kData);
    const std::array<std::vector<int>, 2> entries{appendEntries(packed.color, packed.table),
                                                  appendEntries(packed.data, packed.table)};
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        packed.slots.push_back(
            {static_cast<int>(packed.table.size()), static_cast<int>(uses[i].size())});
        for (const Use& use : uses[i]) {
            const auto slot = static_cast<size_t>(use.slot);
            const MaterialTexture& texture = *materialTextures(m)[slot];
            const glm::mat3& t = texture.pictureFromMesh;
            const auto& list = entries[static_cast<size_t>(kUses[slot])];
            packed.table.push_back(texel(use.slot, list[static_cast<size_t>(use.request)],
                                         texture.uvSet, strengthOf(m, use.slot)));
            packed.table.push_back(texel(t[0].x, t[0].y, t[1].x, t[1].y));
            packed.table.push_back(texel(t[2].x, t[2].y, static_cast<int>(m.roughnessFrom),
                                         static_cast<int>(m.metallicFrom)));
        }
    }
    return packed;
}

void writeStrengths(const Scene& scene, const PackedTextures& textures,
                    std::span<glm::vec4> table) {
    for (size_t i = 0; i < scene.materials.size(); ++i)
        for (int k = 0; k < textures.slots[i].count; ++k) {
            glm::vec4& use = table[static_cast<size_t>(textures.slots[i].first + kUseTexels * k)];
            use.w = strengthOf(scene.materials[i], static_cast<int>(use.x));
        }
}

}  // namespace vitrine
