// SPDX-License-Identifier: MIT
// Ambient occlusion and crevices, baked with the tracer of bvh/.
#pragma once

#include <vector>

#include "bvh/bvh.hpp"
#include "mesh/mesh.hpp"
#include "models/tank/texels.hpp"

namespace vitrine::tank {

/// All that casts shade: the whole tank at rest, on the ground.
struct Occluder {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    Bvh bvh;
};

Occluder makeOccluder(const std::vector<Assembly>& tank);

/// One a texel; where nothing is shown, 1 and 0.
struct Occlusion {
    std::vector<float> open;     ///< 1: the sky is free; 0: nothing comes here
    std::vector<float> crevice;  ///< 1: surrounded within a few centimetres
};

Occlusion bakeOcclusion(const Assembly& assembly, const Atlas& atlas, const TexelGrid& grid,
                        const Occluder& occluder);

}  // namespace vitrine::tank
