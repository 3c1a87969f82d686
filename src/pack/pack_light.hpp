// SPDX-License-Identifier: MIT
// A light as shaders/shade/lights.glsl reads it.
#pragma once

#include <array>

#include "pack/assets.hpp"
#include "scene/scene.hpp"
#include "shared/limits.glsl"

namespace vitrine {

struct PackedLight {
    std::array<glm::vec4, VITRINE_LIGHT_TEXELS> texels;
    bool sized = false;  ///< rays can run into it
};

PackedLight packLight(const Light& light);

/// The sun of a computed sky, which stands where the environment says.
Light sunOfSky(const SkyAsset::Sun& sun, const Environment& environment);

}  // namespace vitrine
