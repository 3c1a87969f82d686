// SPDX-License-Identifier: MIT
// Materials, and which part of a node has which, as shaders/shade/surface.glsl reads them.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "pack/assets.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

class MaterialPacker {
  public:
    /// Packs all materials of the scene and, last, the one of nodes that name none. What a moment
    /// has of them goes to `out`, parameters of snippets to the end of `parameters`. All outlive
    /// this.
    MaterialPacker(const Scene& scene, const Assets& assets, const PackedGeometry& geometry,
                   PackedMoment& out, std::vector<glm::vec4>& parameters, Diagnostics& diagnostics);

    /// First texel, in lists(), of the materials of a node's parts.
    int addParts(const Node& node, const Shape& shape, const std::vector<std::string>& partNames);
    /// VITRINE_INSTANCE_* by the materials of the parts, the list that was added last and starts
    /// here.
    int instanceFlags(int firstOfList, bool field);

    [[nodiscard]] const std::vector<glm::vec4>& materials() const { return materials_; }
    [[nodiscard]] const std::vector<glm::vec4>& lists() const { return lists_; }

  private:
    void add(const Material& m, int snippet, int parameters, const PackedTextures::Slots& slots);
    [[nodiscard]] int byName(const std::string& name) const;
    [[nodiscard]] glm::vec4 listed(int material, size_t parts) const;
    [[nodiscard]] bool snippetMakesGlass(size_t number) const;

    const Scene& scene_;
    const Assets& assets_;
    const PackedGeometry& geometry_;
    PackedMoment& out_;
    std::vector<glm::vec4>& parameters_;
    Diagnostics& diagnostics_;
    std::unordered_map<std::string, int> numbers_;
    std::vector<glm::vec4> materials_, lists_;
};

}  // namespace vitrine
