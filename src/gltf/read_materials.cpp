// SPDX-License-Identifier: MIT
#include "gltf/read_materials.hpp"

#include <fmt/format.h>

namespace vitrine {
namespace {

class MaterialReader {
  public:
    explicit MaterialReader(ReadContext& context) : context_(context) {}

    GltfMaterial read(const JsonValue& material, size_t number) {
        GltfMaterial m;
        m.name = nameOf(material, "material", number);
        readCore(material, m);
        const JsonValue extensions = material.object("extensions");
        m.unlit = extensions.has("KHR_materials_unlit");
        m.emissiveStrength = extensions.object("KHR_materials_emissive_strength")
                                 .number("emissiveStrength", m.emissiveStrength, 0);
        m.ior = readIor(extensions.object("KHR_materials_ior"));
        readGlass(extensions, m);
        readLayers(extensions, m);
        return m;
    }

  private:
    void readCore(const JsonValue& material, GltfMaterial& m) {
        const JsonValue pbr = material.object("pbrMetallicRoughness");
        m.baseColorFactor = pbr.vector<4>("baseColorFactor", m.baseColorFactor, 0, 1);
        m.baseColorTexture = readTexture(pbr, "baseColorTexture");
        m.metallicFactor = pbr.number("metallicFactor", m.metallicFactor, 0, 1);
        m.roughnessFactor = pbr.number("roughnessFactor", m.roughnessFactor, 0, 1);
        m.metallicRoughnessTexture = readTexture(pbr, "metallicRoughnessTexture");
        m.normalTexture = readTexture(material, "normalTexture");
        m.normalScale = material.object("normalTexture").number("scale", m.normalScale);
        m.occlusionTexture = readTexture(material, "occlusionTexture");
        m.occlusionStrength =
            material.object("occlusionTexture").number("strength", m.occlusionStrength, 0, 1);
        m.emissiveFactor = material.vector<3>("emissiveFactor", m.emissiveFactor, 0, 1);
        m.emissiveTexture = readTexture(material, "emissiveTexture");
        m.alphaMode = readAlphaMode(material);
        m.alphaCutoff = material.number("alphaCutoff", m.alphaCutoff, 0);
        m.doubleSided = material.flag("doubleSided", m.doubleSided);
    }

    static GltfAlphaMode readAlphaMode(const JsonValue& material) {
        if (!material.has("alphaMode")) return GltfAlphaMode::kOpaque;
        const std::string mode = material.text("alphaMode");
        if (mode == "MASK") return GltfAlphaMode::kMask;
        if (mode == "BLEND") return GltfAlphaMode::kBlend;
        if (mode != "OPAQUE")
            material.error("alphaMode", inQuotes(mode) + " is none of OPAQUE, MASK and BLEND");
        return GltfAlphaMode::kOpaque;
    }

    /// At least 1, or 0 for a surface that lets nothing through.
    static float readIor(const JsonValue& extension) {
        constexpr float kDefault = 1.5f;
        const float ior = extension.number("ior", kDefault, 0);
        if (ior == 0 || ior >= 1) return ior;
        extension.warning("ior", fmt::format("{} is neither 0 nor at least 1; taken as 1", ior));
        return 1;
    }

    void readGlass(const JsonValue& extensions, GltfMaterial& m) {
        const JsonValue transmission = extensions.object("KHR_materials_transmission");
        m.transmissionFactor =
            transmission.number("transmissionFactor", m.transmissionFactor, 0, 1);
        m.transmissionTexture = readTexture(transmission, "transmissionTexture");
        const JsonValue volume = extensions.object("KHR_materials_volume");
        m.thicknessFactor = volume.number("thicknessFactor", m.thicknessFactor, 0);
        m.thicknessTexture = readTexture(volume, "thicknessTexture");
        m.attenuationDistance = volume.number("attenuationDistance", m.attenuationDistance,
                                              std::numeric_limits<float>::min());
        m.attenuationColor = volume.vector<3>("attenuationColor", m.attenuationColor, 0, 1);
    }

    void readLayers(const JsonValue& extensions, GltfMaterial& m) {
        const JsonValue coat = extensions.object("KHR_materials_clearcoat");
        m.clearcoatFactor = coat.number("clearcoatFactor", m.clearcoatFactor, 0, 1);
        m.clearcoatTexture = readTexture(coat, "clearcoatTexture");
        m.clearcoatRoughnessFactor =
            coat.number("clearcoatRoughnessFactor", m.clearcoatRoughnessFactor, 0, 1);
        m.clearcoatRoughnessTexture = readTexture(coat, "clearcoatRoughnessTexture");
        m.clearcoatNormalTexture = readTexture(coat, "clearcoatNormalTexture");
        m.clearcoatNormalScale =
            coat.object("clearcoatNormalTexture").number("scale", m.clearcoatNormalScale);
        const JsonValue sheen = extensions.object("KHR_materials_sheen");
        m.sheenColorFactor = sheen.vector<3>("sheenColorFactor", m.sheenColorFactor, 0, 1);
        m.sheenColorTexture = readTexture(sheen, "sheenColorTexture");
        m.sheenRoughnessFactor = sheen.number("sheenRoughnessFactor", m.sheenRoughnessFactor, 0, 1);
        m.sheenRoughnessTexture = readTexture(sheen, "sheenRoughnessTexture");
        const JsonValue specular = extensions.object("KHR_materials_specular");
        m.specularFactor = specular.number("specularFactor", m.specularFactor, 0, 1);
        m.specularTexture = readTexture(specular, "specularTexture");
        m.specularColorFactor = specular.vector<3>("specularColorFactor", m.specularColorFactor, 0);
        m.specularColorTexture = readTexture(specular, "specularColorTexture");
    }

    GltfTextureInfo readTexture(const JsonValue& object, std::string_view key) {
        GltfTextureInfo info;
        const JsonValue value = object.object(key);
        if (!value.exists()) return info;
        if (!value.has("index")) value.error("'index' is missing");
        info.texture = value.index("index", context_.model.textures.size());
        const JsonValue transform = value.object("extensions").object("KHR_texture_transform");
        const uint64_t texCoord = transform.whole("texCoord", value.whole("texCoord", 0));
        info.texCoord = static_cast<int>(std::min<uint64_t>(texCoord, 1));
        if (texCoord > 1) {
            value.warning("texCoord",
                          "only the sets 0 and 1 are supported; the texture is left out");
            info.texture = kNoIndex;
        }
        info.offset = transform.vector<2>("offset", info.offset);
        info.rotation = transform.number("rotation", info.rotation);
        info.scale = transform.vector<2>("scale", info.scale);
        return info;
    }

    ReadContext& context_;
};

}  // namespace

void readMaterials(ReadContext& context) {
    const JsonValue materials = context.root.array("materials");
    if (!context.spend(&GltfLimits::materials, materials.size(), "materials", materials)) return;
    MaterialReader reader(context);
    for (size_t i = 0; i < materials.size(); ++i)
        context.model.materials.push_back(reader.read(materials.objectAt(i), i));
}

}  // namespace vitrine
