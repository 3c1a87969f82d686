// SPDX-License-Identifier: MIT
// A light as shaders/shade/lights.glsl reads it.
#pragma once

#include <array>

#include "scene/scene.hpp"
#include "shared/limits.glsl"

namespace vitrine {

struct PackedLight {
    std::array<glm::vec4, VITRINE_LIGHT_TEXELS> texels;
    bool sized = false;  ///< rays can run into it
};

PackedLight packLight(const Light& light);

}  // namespace vitrine
