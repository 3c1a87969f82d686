// SPDX-License-Identifier: MIT
#include "gltf/test_model.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;
using GltfMaterials = GltfTest;

/// With ten textures of one picture.
TestModel withTextures() {
    TestModel model;
    const auto png = encodePng(ImageRgba8(3, 2));
    model.add("images", {{"bufferView", model.addView(png)}, {"mimeType", "image/png"}});
    for (int i = 0; i < 10; ++i) model.add("textures", {{"source", 0}});
    return model;
}

TEST_F(GltfMaterials, DefaultsAreThoseOfTheSpecification) {
    TestModel model;
    model.add("materials", Json::object());
    const GltfMaterial m = readGood(model).materials.at(0);
    EXPECT_EQ(m.name, "material 0");
    EXPECT_EQ(m.baseColorFactor, glm::vec4(1));
    EXPECT_EQ(m.metallicFactor, 1);
    EXPECT_EQ(m.roughnessFactor, 1);
    EXPECT_EQ(m.emissiveFactor, glm::vec3(0));
    EXPECT_EQ(m.alphaMode, GltfAlphaMode::kOpaque);
    EXPECT_EQ(m.alphaCutoff, 0.5f);
    EXPECT_FALSE(m.doubleSided || m.unlit);
    EXPECT_EQ(m.ior, 1.5f);
    EXPECT_EQ(m.attenuationDistance, std::numeric_limits<float>::infinity());
    EXPECT_EQ(m.specularFactor, 1);
    EXPECT_EQ(m.specularColorFactor, glm::vec3(1));
    EXPECT_EQ(m.baseColorTexture.texture, kNoIndex);
}

TEST_F(GltfMaterials, ReadsMetallicRoughness) {
    TestModel model = withTextures();
    model.add("materials", Json::parse(R"({
        "name": "brass",
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.1, 0.2, 0.3, 0.4], "baseColorTexture": {"index": 1},
            "metallicFactor": 0.5, "roughnessFactor": 0.25,
            "metallicRoughnessTexture": {"index": 2, "texCoord": 1}},
        "normalTexture": {"index": 3, "scale": -2},
        "occlusionTexture": {"index": 4, "strength": 0.75},
        "emissiveFactor": [1, 0.5, 0], "emissiveTexture": {"index": 5},
        "alphaMode": "MASK", "alphaCutoff": 0.3, "doubleSided": true})"));
    const GltfMaterial m = readGood(model).materials.at(0);
    EXPECT_EQ(m.name, "brass");
    EXPECT_EQ(m.baseColorFactor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.baseColorTexture.texture, 1);
    EXPECT_EQ(m.metallicFactor, 0.5f);
    EXPECT_EQ(m.roughnessFactor, 0.25f);
    EXPECT_EQ(m.metallicRoughnessTexture.texture, 2);
    EXPECT_EQ(m.metallicRoughnessTexture.texCoord, 1);
    EXPECT_EQ(m.normalTexture.texture, 3);
    EXPECT_EQ(m.normalScale, -2);
    EXPECT_EQ(m.occlusionTexture.texture, 4);
    EXPECT_EQ(m.occlusionStrength, 0.75f);
    EXPECT_EQ(m.emissiveFactor, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(m.emissiveTexture.texture, 5);
    EXPECT_EQ(m.alphaMode, GltfAlphaMode::kMask);
    EXPECT_EQ(m.alphaCutoff, 0.3f);
    EXPECT_TRUE(m.doubleSided);
}

TEST_F(GltfMaterials, ReadsExtensions) {
    TestModel model = withTextures();
    model.add("materials", Json::parse(R"({"alphaMode": "BLEND", "extensions": {
        "KHR_materials_unlit": {},
        "KHR_materials_emissive_strength": {"emissiveStrength": 12},
        "KHR_materials_ior": {"ior": 1.33},
        "KHR_materials_transmission": {"transmissionFactor": 0.9, "transmissionTexture": {"index": 0}},
        "KHR_materials_volume": {"thicknessFactor": 2, "thicknessTexture": {"index": 1},
            "attenuationDistance": 3, "attenuationColor": [0.5, 0.6, 0.7]},
        "KHR_materials_clearcoat": {"clearcoatFactor": 0.8, "clearcoatTexture": {"index": 2},
            "clearcoatRoughnessFactor": 0.1, "clearcoatRoughnessTexture": {"index": 3},
            "clearcoatNormalTexture": {"index": 4, "scale": 0.5}},
        "KHR_materials_sheen": {"sheenColorFactor": [0.1, 0.2, 0.3], "sheenColorTexture": {"index": 5},
            "sheenRoughnessFactor": 0.4, "sheenRoughnessTexture": {"index": 6}},
        "KHR_materials_specular": {"specularFactor": 0.7, "specularTexture": {"index": 7},
            "specularColorFactor": [2, 1, 0], "specularColorTexture": {"index": 8}}}})"));
    const GltfMaterial m = readGood(model).materials.at(0);
    EXPECT_EQ(m.alphaMode, GltfAlphaMode::kBlend);
    EXPECT_TRUE(m.unlit);
    EXPECT_EQ(m.emissiveStrength, 12);
    EXPECT_EQ(m.ior, 1.33f);
    EXPECT_EQ(m.transmissionFactor, 0.9f);
    EXPECT_EQ(m.transmissionTexture.texture, 0);
    EXPECT_EQ(m.thicknessFactor, 2);
    EXPECT_EQ(m.thicknessTexture.texture, 1);
    EXPECT_EQ(m.attenuationDistance, 3);
    EXPECT_EQ(m.attenuationColor, glm::vec3(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(m.clearcoatFactor, 0.8f);
    EXPECT_EQ(m.clearcoatTexture.texture, 2);
    EXPECT_EQ(m.clearcoatRoughnessFactor, 0.1f);
    EXPECT_EQ(m.clearcoatRoughnessTexture.texture, 3);
    EXPECT_EQ(m.clearcoatNormalTexture.texture, 4);
    EXPECT_EQ(m.clearcoatNormalScale, 0.5f);
    EXPECT_EQ(m.sheenColorFactor, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.sheenColorTexture.texture, 5);
    EXPECT_EQ(m.sheenRoughnessFactor, 0.4f);
    EXPECT_EQ(m.sheenRoughnessTexture.texture, 6);
    EXPECT_EQ(m.specularFactor, 0.7f);
    EXPECT_EQ(m.specularTexture.texture, 7);
    EXPECT_EQ(m.specularColorFactor, glm::vec3(2, 1, 0));
    EXPECT_EQ(m.specularColorTexture.texture, 8);
}

TEST_F(GltfMaterials, TransformsTextureCoordinates) {
    TestModel model = withTextures();
    model.add("materials", Json::parse(R"({"normalTexture": {"index": 0, "extensions": {
        "KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 0.7853981633974483,
                                  "scale": [2, 3], "texCoord": 1}}}})"));
    const GltfTextureInfo info = readGood(model).materials.at(0).normalTexture;
    EXPECT_EQ(info.texCoord, 1);
    EXPECT_EQ(info.offset, glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(info.scale, glm::vec2(2, 3));

    const auto apply = [](const GltfTextureInfo& i, glm::vec2 uv) {
        return glm::vec2(uvFromMeshUv(i) * glm::vec3(uv, 1));
    };
    const auto expectNear = [](glm::vec2 a, glm::vec2 b) {
        EXPECT_NEAR(a.x, b.x, 1e-6f);
        EXPECT_NEAR(a.y, b.y, 1e-6f);
    };
    expectNear(apply({}, {0.25f, 0.125f}), {0.25f, 0.125f});
    // The upper left corner, glTF's origin, stays under a rotation; what is right of it goes up.
    GltfTextureInfo quarterTurn;
    quarterTurn.rotation = kPi / 2;
    expectNear(apply(quarterTurn, {0, 1}), {0, 1});
    expectNear(apply(quarterTurn, {1, 1}), {0, 2});
    // By hand: scaled to (2, 3) in glTF's axes, turned by 45 degrees, moved.
    const float h = std::sqrt(0.5f);
    expectNear(apply(info, {1, 0}), {0.5f + h * (2 + 3), 1 - (0.25f + h * (3 - 2))});
}

TEST_F(GltfMaterials, NumbersOutOfRangeAreClamped) {
    TestModel model;
    model.add("materials", Json::parse(R"({"pbrMetallicRoughness": {"roughnessFactor": 1.5},
        "emissiveFactor": [0, -1, 1e99], "extensions": {"KHR_materials_ior": {"ior": 0.5}}})"));
    const auto result = read(model.glb());
    EXPECT_EQ(
        messages,
        "m.glb: warning: /materials/0/pbrMetallicRoughness/roughnessFactor: 1.5 is not in the "
        "range 0 to 1; taken as 1\n"
        "m.glb: warning: /materials/0/emissiveFactor/1: -1 is not in the range 0 to 1; taken as "
        "0\n"
        "m.glb: warning: /materials/0/emissiveFactor/2: inf is not in the range 0 to 1; taken "
        "as 1\n"
        "m.glb: warning: /materials/0/extensions/KHR_materials_ior/ior: 0.5 is neither 0 nor at "
        "least 1; taken as 1");
    ASSERT_TRUE(result);
    EXPECT_EQ(result->materials[0].emissiveFactor, glm::vec3(0, 0, 1));
}

TEST_F(GltfMaterials, OtherExtensionsAreNamedOnce) {
    TestModel model;
    model.json["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness", "EXT_x",
                                    "KHR_materials_unlit", "EXT_x"};
    EXPECT_TRUE(read(model.gltf(1), "m.gltf"));
    EXPECT_EQ(messages,
              "m.gltf:5:20: warning: /extensionsUsed: the extension "
              "'KHR_materials_pbrSpecularGlossiness' is not supported and ignored\n"
              "m.gltf:5:20: warning: /extensionsUsed: the extension 'EXT_x' is not supported and "
              "ignored");
    model.json["extensionsRequired"] = {"KHR_materials_unlit", "EXT_x"};
    EXPECT_FALSE(read(model.gltf(), "m.gltf"));
    EXPECT_NE(messages.find("m.gltf:1:49: error: /extensionsRequired: the file cannot be shown "
                            "without the extension 'EXT_x', which is not supported"),
              std::string::npos)
        << messages;
}

TEST_F(GltfMaterials, PartsAreNamedAfterThem) {
    TestModel model = square();
    model.add("materials", {{"name", "linen"}});
    model.json["meshes"][0]["primitives"][0]["material"] = 0;
    const GltfPrimitive primitive = readGood(model).meshes.at(0).primitives.at(0);
    EXPECT_EQ(primitive.material, 0);
    EXPECT_EQ(primitive.mesh.partNames, std::vector<std::string>{"linen"});
}

}  // namespace
}  // namespace vitrine
