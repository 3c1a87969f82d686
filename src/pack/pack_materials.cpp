// SPDX-License-Identifier: MIT
#include "pack/pack_materials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "pack/parameters.hpp"

namespace vitrine {
namespace {

glm::vec4 texel(int x, int y = 0, int z = 0, int w = 0) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
            static_cast<float>(w)};
}

/// Whether a snippet may set one of these members.
bool mentions(const Snippet& snippet, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
        return snippet.source.find(word) != std::string::npos;
    });
}

int flagsOf(const Material& m) {
    int flags = static_cast<int>(m.alphaMode);
    if (!m.doubleSided) flags |= VITRINE_MATERIAL_SINGLE_SIDED;
    if (m.unlit) flags |= VITRINE_MATERIAL_UNLIT;
    if (m.thin) flags |= VITRINE_MATERIAL_THIN;
    if (m.model != SurfaceModel::kPbr) flags |= VITRINE_MATERIAL_CLASSIC;
    return flags;
}

/// Per metre (Beer's law).
glm::vec3 absorptionOf(const Material& m) {
    if (m.attenuationDistance <= 0) return glm::vec3(0);
    return -glm::log(glm::max(m.attenuationColor.rgb, glm::vec3(1e-6f))) / m.attenuationDistance;
}

}  // namespace

MaterialPacker::MaterialPacker(const Scene& scene, const Assets& assets,
                               const PackedGeometry& geometry, PackedMoment& out,
                               std::vector<glm::vec4>& parameters, Diagnostics& diagnostics)
    : scene_(scene),
      assets_(assets),
      geometry_(geometry),
      out_(out),
      parameters_(parameters),
      diagnostics_(diagnostics) {
    for (size_t i = 0; i < scene.materials.size(); ++i)
        numbers_.emplace(scene.materials[i].name, static_cast<int>(i));
    for (size_t i = 0; i < scene_.materials.size(); ++i) {
        int snippet = 0, firstParameter = 0;
        if (const auto& asset = assets_.materials[i]) {
            snippet = 1 + numberOf(asset, geometry_.materialSnippets);
            firstParameter = addParameters(
                parameterValues(*asset, scene_.materials[i].set, diagnostics_), parameters_);
        } else if (!scene_.materials[i].set.empty() && scene_.materials[i].snippet.empty()) {
            diagnostics_.error(scene_.materials[i].set[0].where,
                               "set gives parameters to a snippet, but the material has none");
        }
        add(scene_.materials[i], snippet, firstParameter, geometry_.textures.slots[i]);
    }
    for (const auto& snippet : geometry_.materialSnippets) {
        out_.hasLayers |= mentions(*snippet, {"clearcoat", "sheenColor"});
        out_.hasTransmission |= mentions(*snippet, {"transmission"});
        out_.hasSubsurface |= mentions(*snippet, {"subsurface"});
        out_.hasCurvature |= mentions(*snippet, {"curvature"});
    }
    add(Material{}, 0, 0, {});  // for nodes that name none
    out_.materialNames.back() = "(default)";
}

void MaterialPacker::add(const Material& m, int snippet, int parameters,
                         const PackedTextures::Slots& slots) {
    out_.materialNames.push_back(m.name);
    out_.hasLayers |= m.clearcoat > 0 || m.sheenColor.rgb != glm::vec3(0);
    const bool classic = m.model != SurfaceModel::kPbr;
    const float transmission = classic ? 0 : m.transmission;
    out_.hasClassic |= classic;
    out_.hasTransmission |= transmission > 0;
    materials_.emplace_back(m.baseColor.rgb, m.metallic);
    materials_.emplace_back(m.emission.rgb * m.emissionStrength, m.roughness);
    materials_.push_back(texel(snippet, parameters, flagsOf(m)));
    materials_.back().w = m.specular;
    materials_.push_back(texel(slots.first, slots.count));
    materials_.back().z = m.opacity;
    materials_.back().w = m.alphaCutoff;
    materials_.emplace_back(m.specularColor.rgb, m.ior);
    materials_.emplace_back(absorptionOf(m), transmission);
    materials_.emplace_back(m.clearcoat, m.clearcoatRoughness, 0.0f, 0.0f);
    materials_.emplace_back(m.sheenColor.rgb, m.sheenRoughness);
    const float subsurface = classic ? 0 : std::max(m.subsurface, scene_.render.sssAll);
    out_.hasSubsurface |= subsurface > 0;
    materials_.emplace_back(subsurface * m.subsurfaceColor.rgb, m.subsurfaceRadius);
    const bool highlight = m.model == SurfaceModel::kBlinnPhong;
    materials_.emplace_back(highlight ? m.highlightColor.rgb : glm::vec3(0), m.shininess);
}

/// What the materials of a node's parts are listed by: number, length of the list, and over
/// what radius curvature is taken (0: nobody asks).
glm::vec4 MaterialPacker::listed(int material, size_t parts) const {
    glm::vec4 entry = texel(material, static_cast<int>(parts));
    const auto i = static_cast<size_t>(material);
    if (i < scene_.materials.size() && assets_.materials[i] != nullptr &&
        mentions(*assets_.materials[i], {"curvature"}))
        entry.z = scene_.materials[i].curvatureRadius;
    return entry;
}

int MaterialPacker::byName(const std::string& name) const {
    const auto found = numbers_.find(name);
    return found == numbers_.end() ? -1 : found->second;
}

int MaterialPacker::addParts(const Node& node, const Shape& shape,
                             const std::vector<std::string>& partNames) {
    const int unnamed = static_cast<int>(out_.materialNames.size()) - 1;
    const int whole = node.material.empty() ? unnamed : byName(node.material.name);
    std::vector<int> chosen(partNames.size(), whole);
    if (node.material.empty())
        for (size_t i = 0; i < shape.partMaterials.size() && i < partNames.size(); ++i)
            chosen[i] = byName(shape.partMaterials[i].second);
    for (size_t i = 0; i < node.parts.size(); ++i) {
        const auto& [part, material] = node.parts[i];
        const auto found = std::find(partNames.begin(), partNames.end(), part);
        if (found == partNames.end())
            diagnostics_.error(
                node.partPlaces[i],
                fmt::format("shape '{}' has no part '{}'{}; its parts are '{}'", node.shape.name,
                            part, didYouMean(part, partNames), fmt::join(partNames, "', '")));
        else
            chosen[static_cast<size_t>(found - partNames.begin())] = byName(material.name);
    }
    const auto first = static_cast<int>(lists_.size());
    for (const int material : chosen)
        lists_.push_back(listed(std::max(material, 0), chosen.size()));
    return first;
}

bool MaterialPacker::snippetMakesGlass(size_t number) const {
    return number > 0 && mentions(*geometry_.materialSnippets[number - 1], {"transmission"});
}

int MaterialPacker::instanceFlags(int firstOfList, bool field) {
    bool filtered = false, allCulled = true, someCulled = false;
    for (auto i = static_cast<size_t>(firstOfList); i < lists_.size(); ++i) {
        const auto m = static_cast<size_t>(lists_[i].x);
        const glm::vec4* texels = &materials_[m * VITRINE_MATERIAL_TEXELS];
        const int flags = static_cast<int>(texels[2].z);
        const bool glass = texels[5].w > 0 || snippetMakesGlass(static_cast<size_t>(texels[2].x));
        filtered |= glass || (flags & (VITRINE_ALPHA_MASK | VITRINE_ALPHA_BLEND)) != 0;
        const bool culled = (flags & VITRINE_MATERIAL_SINGLE_SIDED) != 0 && !glass;
        allCulled &= culled;
        someCulled |= culled;
    }
    // Parts of both kinds, or fields, whose backs are met only by rays inside of them.
    if (someCulled && (!allCulled || field)) filtered = true;
    const bool culled = allCulled && !field;
    out_.hasFilters |= filtered;
    out_.hasCulling |= culled;
    return (filtered ? VITRINE_INSTANCE_FILTERED : 0) | (culled ? VITRINE_INSTANCE_CULLED : 0);
}

}  // namespace vitrine
