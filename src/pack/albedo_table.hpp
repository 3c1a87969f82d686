// SPDX-License-Identifier: MIT
// How much light the lobes of reflection send back in all directions: what layers leave to those
// below, and what microfacets lose that see only their first bounce.
#pragma once

#include <vector>

#include "base/math.hpp"

namespace vitrine {

/// VITRINE_ALBEDO_COSINES times VITRINE_ALBEDO_ROUGHNESSES texels; the cosine between the normal
/// and the viewer runs fastest, from 0 to 1; then the roughness, from 0 to 1. A GGX lobe with
/// Schlick's Fresnel sends back f0 * x + f90 * y, a sheen lobe z. Lobes as in
/// shaders/lib/brdf.glsl.
const std::vector<glm::vec4>& albedoTable();

}  // namespace vitrine
