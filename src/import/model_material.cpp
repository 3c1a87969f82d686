// SPDX-License-Identifier: MIT
#include "import/model_material.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

TextureWrap wrapOf(GltfWrap wrap) {
    switch (wrap) {
        case GltfWrap::kRepeat:
            return TextureWrap::kRepeat;
        case GltfWrap::kMirroredRepeat:
            return TextureWrap::kMirror;
        case GltfWrap::kClampToEdge:
            return TextureWrap::kClamp;
    }
    return TextureWrap::kRepeat;
}

/// Where a texture of a glTF material goes in a scene's.
struct TexturePair {
    GltfTextureInfo GltfMaterial::*from;
    MaterialTexture Material::*to;
};
using G = GltfMaterial;
using M = Material;
constexpr std::array kTextures{
    TexturePair{&G::baseColorTexture, &M::baseColorTexture},
    TexturePair{&G::metallicRoughnessTexture, &M::metallicRoughnessTexture},
    TexturePair{&G::normalTexture, &M::normalTexture},
    TexturePair{&G::occlusionTexture, &M::occlusionTexture},
    TexturePair{&G::emissiveTexture, &M::emissionTexture},
    TexturePair{&G::transmissionTexture, &M::transmissionTexture},
    TexturePair{&G::specularTexture, &M::specularTexture},
    TexturePair{&G::specularColorTexture, &M::specularColorTexture},
    TexturePair{&G::clearcoatTexture, &M::clearcoatTexture},
    TexturePair{&G::clearcoatRoughnessTexture, &M::clearcoatRoughnessTexture},
    TexturePair{&G::clearcoatNormalTexture, &M::clearcoatNormalTexture},
    TexturePair{&G::sheenColorTexture, &M::sheenColorTexture},
    TexturePair{&G::sheenRoughnessTexture, &M::sheenRoughnessTexture}};

MaterialTexture textureOf(const GltfModel& model, const GltfTextureInfo& info,
                          const PictureSource& pictureOf) {
    MaterialTexture result;
    if (info.texture == kNoIndex) return result;
    const GltfTexture& texture = model.textures[static_cast<size_t>(info.texture)];
    if (texture.image == kNoIndex) return result;
    result.image = pictureOf(texture.image);
    result.wrapU = wrapOf(texture.wrapS);
    result.wrapV = wrapOf(texture.wrapT);
    result.nearest = texture.magFilter == GltfFilter::kNearest;
    result.uvSet = info.texCoord;
    result.pictureFromMesh = uvFromMeshUv(info);
    return result;
}

AlphaMode alphaModeOf(GltfAlphaMode mode) {
    switch (mode) {
        case GltfAlphaMode::kOpaque:
            return AlphaMode::kOpaque;
        case GltfAlphaMode::kMask:
            return AlphaMode::kMask;
        case GltfAlphaMode::kBlend:
            return AlphaMode::kBlend;
    }
    return AlphaMode::kOpaque;
}

}  // namespace

Material materialOf(const GltfModel& model, int material, const PictureSource& pictureOf) {
    const GltfMaterial standard;
    const GltfMaterial& g =
        material == kNoIndex ? standard : model.materials[static_cast<size_t>(material)];
    Material m;
    m.baseColor.rgb = glm::vec3(g.baseColorFactor);
    m.opacity = g.baseColorFactor.w;
    m.metallic = g.metallicFactor;
    m.roughness = g.roughnessFactor;
    m.emission.rgb = g.emissiveFactor;
    m.emissionStrength = g.emissiveStrength;
    m.normalScale = g.normalScale;
    m.occlusionStrength = g.occlusionStrength;
    m.alphaMode = alphaModeOf(g.alphaMode);
    m.alphaCutoff = g.alphaCutoff;
    m.doubleSided = g.doubleSided;
    m.unlit = g.unlit;
    // KHR_materials_ior lets 0 stand for a surface that reflects all: that is the limit of an
    // index that grows without end, and this one reflects 99.6 % straight on.
    m.ior = g.ior == 0 ? 1000.0f : g.ior;
    m.specular = g.specularFactor;
    m.specularColor.rgb = g.specularColorFactor;
    m.transmission = g.transmissionFactor;
    // The thickness is a hint for renderers that do not follow rays; only zero says something.
    m.thin = g.transmissionFactor > 0 && g.thicknessFactor == 0;
    m.attenuationColor.rgb = g.attenuationColor;
    m.attenuationDistance = std::isfinite(g.attenuationDistance) ? g.attenuationDistance : 0;
    m.clearcoat = g.clearcoatFactor;
    m.clearcoatRoughness = g.clearcoatRoughnessFactor;
    m.clearcoatNormalScale = g.clearcoatNormalScale;
    m.sheenColor.rgb = g.sheenColorFactor;
    m.sheenRoughness = g.sheenRoughnessFactor;
    for (const TexturePair& pair : kTextures)
        m.*pair.to = textureOf(model, g.*pair.from, pictureOf);
    return m;
}

bool usesSecondUvs(const GltfMaterial& material) {
    return std::any_of(kTextures.begin(), kTextures.end(), [&](const TexturePair& pair) {
        const GltfTextureInfo& info = material.*pair.from;
        return info.texture != kNoIndex && info.texCoord == 1;
    });
}

}  // namespace vitrine
