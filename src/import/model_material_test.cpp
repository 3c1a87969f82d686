// SPDX-License-Identifier: MIT
#include "import/model_material.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

std::shared_ptr<const ImageRgba8> noPicture(int) {
    return std::make_shared<ImageRgba8>(1, 1);
}

TEST(ModelMaterial, WithoutAnyIsAWhiteMetal) {
    const Material m = materialOf(GltfModel{}, kNoIndex, noPicture);
    EXPECT_EQ(m.baseColor.rgb, glm::vec3(1));
    EXPECT_EQ(m.metallic, 1);
    EXPECT_EQ(m.roughness, 1);
    EXPECT_EQ(m.opacity, 1);
    EXPECT_EQ(m.emission.rgb, glm::vec3(0));
    EXPECT_FALSE(m.doubleSided || m.unlit || m.thin || m.baseColorTexture.given());
}

TEST(ModelMaterial, EveryNumberArrives) {
    GltfModel model;
    GltfMaterial& g = model.materials.emplace_back();
    g.baseColorFactor = {0.1f, 0.2f, 0.3f, 0.4f};
    g.metallicFactor = 0.15f;
    g.roughnessFactor = 0.25f;
    g.normalScale = -2;
    g.occlusionStrength = 0.6f;
    g.emissiveFactor = {0.5f, 0.6f, 0.7f};
    g.emissiveStrength = 8;
    g.alphaMode = GltfAlphaMode::kMask;
    g.alphaCutoff = 0.35f;
    g.doubleSided = g.unlit = true;
    g.ior = 1.33f;
    g.transmissionFactor = 0.9f;
    g.thicknessFactor = 2;
    g.attenuationDistance = 3;
    g.attenuationColor = {0.9f, 0.8f, 0.7f};
    g.clearcoatFactor = 0.45f;
    g.clearcoatRoughnessFactor = 0.55f;
    g.clearcoatNormalScale = 0.65f;
    g.sheenColorFactor = {0.11f, 0.12f, 0.13f};
    g.sheenRoughnessFactor = 0.75f;
    g.specularFactor = 0.85f;
    g.specularColorFactor = {0.21f, 0.22f, 2};
    const Material m = materialOf(model, 0, noPicture);
    EXPECT_EQ(m.baseColor.rgb, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.opacity, 0.4f);
    EXPECT_EQ(m.metallic, 0.15f);
    EXPECT_EQ(m.roughness, 0.25f);
    EXPECT_EQ(m.normalScale, -2);
    EXPECT_EQ(m.occlusionStrength, 0.6f);
    EXPECT_EQ(m.emission.rgb, glm::vec3(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(m.emissionStrength, 8);
    EXPECT_EQ(m.alphaMode, AlphaMode::kMask);
    EXPECT_EQ(m.alphaCutoff, 0.35f);
    EXPECT_TRUE(m.doubleSided && m.unlit);
    EXPECT_EQ(m.ior, 1.33f);
    EXPECT_EQ(m.transmission, 0.9f);
    EXPECT_FALSE(m.thin);
    EXPECT_EQ(m.attenuationDistance, 3);
    EXPECT_EQ(m.attenuationColor.rgb, glm::vec3(0.9f, 0.8f, 0.7f));
    EXPECT_EQ(m.clearcoat, 0.45f);
    EXPECT_EQ(m.clearcoatRoughness, 0.55f);
    EXPECT_EQ(m.clearcoatNormalScale, 0.65f);
    EXPECT_EQ(m.sheenColor.rgb, glm::vec3(0.11f, 0.12f, 0.13f));
    EXPECT_EQ(m.sheenRoughness, 0.75f);
    EXPECT_EQ(m.specular, 0.85f);
    EXPECT_EQ(m.specularColor.rgb, glm::vec3(0.21f, 0.22f, 2));

    model.materials[0].thicknessFactor = 0;
    model.materials[0].ior = 0;
    model.materials[0].attenuationDistance = std::numeric_limits<float>::infinity();
    const Material wall = materialOf(model, 0, noPicture);
    EXPECT_TRUE(wall.thin) << "no thickness: a thin wall";
    EXPECT_GT(wall.ior, 100) << "0 stands for total reflection";
    EXPECT_EQ(wall.attenuationDistance, 0) << "nothing is absorbed";
}

TEST(ModelMaterial, EveryTextureGoesToItsOwnPlace) {
    GltfModel model;
    GltfMaterial& g = model.materials.emplace_back();
    std::vector<GltfTextureInfo*> infos{
        &g.baseColorTexture,          &g.metallicRoughnessTexture, &g.normalTexture,
        &g.occlusionTexture,          &g.emissiveTexture,          &g.transmissionTexture,
        &g.specularTexture,           &g.specularColorTexture,     &g.clearcoatTexture,
        &g.clearcoatRoughnessTexture, &g.clearcoatNormalTexture,   &g.sheenColorTexture,
        &g.sheenRoughnessTexture};
    for (size_t i = 0; i < infos.size(); ++i) {
        infos[i]->texture = static_cast<int>(i);
        model.textures.push_back({static_cast<int>(2 * i)});
    }
    std::vector<int> asked;
    const Material m = materialOf(model, 0, [&](int image) {
        asked.push_back(image);
        return std::make_shared<ImageRgba8>(image + 1, 1);
    });
    const std::vector<const MaterialTexture*> textures{
        &m.baseColorTexture,          &m.metallicRoughnessTexture, &m.normalTexture,
        &m.occlusionTexture,          &m.emissionTexture,          &m.transmissionTexture,
        &m.specularTexture,           &m.specularColorTexture,     &m.clearcoatTexture,
        &m.clearcoatRoughnessTexture, &m.clearcoatNormalTexture,   &m.sheenColorTexture,
        &m.sheenRoughnessTexture};
    for (size_t i = 0; i < textures.size(); ++i) {
        ASSERT_NE(textures[i]->image, nullptr) << i;
        EXPECT_EQ(textures[i]->image->width, static_cast<int>(2 * i) + 1) << i;
    }
    EXPECT_EQ(asked.size(), 13u);
    EXPECT_FALSE(usesSecondUvs(g));
    g.sheenRoughnessTexture.texCoord = 1;
    EXPECT_TRUE(usesSecondUvs(g));
}

TEST(ModelMaterial, SamplersAndTransformsArrive) {
    GltfModel model;
    GltfTexture texture{0, GltfWrap::kMirroredRepeat, GltfWrap::kClampToEdge};
    texture.magFilter = GltfFilter::kNearest;
    model.textures = {texture, GltfTexture{}};
    GltfMaterial& g = model.materials.emplace_back();
    g.baseColorTexture = {0, 1, {0.25f, 0.5f}, 0.5f, {2, 3}};
    g.emissiveTexture.texture = 1;  // has no image: in a format that is not read
    const Material m = materialOf(model, 0, noPicture);
    EXPECT_EQ(m.baseColorTexture.wrapU, TextureWrap::kMirror);
    EXPECT_EQ(m.baseColorTexture.wrapV, TextureWrap::kClamp);
    EXPECT_TRUE(m.baseColorTexture.nearest);
    EXPECT_EQ(m.baseColorTexture.uvSet, 1);
    EXPECT_EQ(m.baseColorTexture.pictureFromMesh, uvFromMeshUv(g.baseColorTexture));
    EXPECT_NE(m.baseColorTexture.pictureFromMesh, glm::mat3(1));
    EXPECT_FALSE(m.emissionTexture.given());
}

}  // namespace
}  // namespace vitrine
