// SPDX-License-Identifier: MIT
// A clear or hazy sky and its sun, computed: Rayleigh and Mie scattering and ozone in a spherical
// atmosphere. Single scattering after Nishita et al. (Display of the Earth Taking into Account
// Atmospheric Scattering, SIGGRAPH 1993); all further scattering by the isotropic estimate of
// Hillaire (A Scalable and Production Ready Sky and Atmosphere Rendering Technique, EGSR 2020),
// whose coefficients are used too.
#pragma once

#include "base/math.hpp"
#include "image/image.hpp"

namespace vitrine {

struct AtmosphereRequest {
    float sunElevation = 40;  ///< degrees above the horizon
    float turbidity = 2.5f;   ///< 1: no haze
    glm::vec3 ground{0.2f};   ///< reflectance
};

/// Radiance without the sun's disc, equirectangular as in pack/sky_map.hpp with the sun over the
/// middle, and what the disc adds.
///
/// Scale: the sun outside of the atmosphere gives kSunIrradiance, so that a clear noon is about
/// right with an exposure of 0. An eye gets used to darkness; so does the scale: `adaptation` is
/// 1 around noon and grows as the light fades, by less than the light fades.
struct Atmosphere {
    ImageRgba32f sky;
    glm::vec3 sunIrradiance{0};  ///< on a surface that faces the sun
    float adaptation = 1;        ///< is in both of the above
};
inline constexpr float kSunIrradiance = 4.2f;
inline constexpr float kSunRadiusDegrees = 0.2666f;

Atmosphere makeAtmosphere(const AtmosphereRequest& request);

}  // namespace vitrine
