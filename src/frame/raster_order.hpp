// SPDX-License-Identifier: MIT
// In which order the rasteriser takes the triangles of each mesh: shells together, so that their
// backs can be left out. For a software driver a triangle that is not drawn costs a tenth of one
// that is.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "gpu/raster_pass.hpp"
#include "mesh/shells.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

class RasterOrder {
  public:
    /// Takes in the meshes that it does not know. True if there were any: indices() is longer.
    bool add(std::span<const PackedInstance> instances);

    /// The corners of all triangles, counted from the first of their mesh.
    [[nodiscard]] const std::vector<uint32_t>& indices() const { return indices_; }

    /// What of the instance is to be drawn with the backs left out, and what with them.
    struct Ranges {
        std::vector<RasterRange> culled, whole;
    };
    /// `eye` in world space.
    [[nodiscard]] Ranges ranges(const PackedInstance& instance, const glm::vec3& eye) const;

  private:
    struct Known {
        std::vector<Shell> shells;
        uint32_t firstIndex = 0, triangles = 0;
    };
    std::map<std::shared_ptr<const MeshAsset>, Known> meshes_;
    std::vector<uint32_t> indices_;
};

}  // namespace vitrine
