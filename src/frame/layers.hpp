// SPDX-License-Identifier: MIT
// A picture as data: the light of the scene before exposure and tone map, and beside it what the
// first hits say.
#pragma once

#include <cstdint>

#include "gpu/texture.hpp"
#include "image/image.hpp"

namespace vitrine {

/// Where there is no surface: the depth (as Blender writes it) and the numbers.
inline constexpr float kNoDepth = 1e10f;
inline constexpr uint32_t kNoId = 0xffffffffu;

/// All of the same size, top row first. Numbers and depth are of one ray, near the middle of the
/// pixel; the others are means over the pixel's rays (render.ssaa).
struct LayerImages {
    ImageRgba32f light;      // linear scene radiance, mean of all samples; alpha 1
    Image<float, 3> albedo;  // linear; 0 where there is no surface
    Image<float, 3> normal;  // world space, unit, towards the viewer; 0 where there is no surface
    ImageMap depth;          // along the view axis, m
    Image<uint32_t, 3> ids;  // instance; primitive of a mesh or part of a field; material
};

/// What the pass `layers` writes.
struct LayerTextures {
    Texture ids, albedo, normal;
    void allocate(int width, int height);
};

/// `mean`: of the samples' radiance. Blocks of `ssaa` by `ssaa` texels become one pixel.
LayerImages readLayers(const Texture& mean, const LayerTextures& textures, int ssaa);

}  // namespace vitrine
