// SPDX-License-Identifier: MIT
// A picture of all directions, ready to light a scene: smaller versions of it to filter with, the
// part that is bright enough to be sampled as a light, and trees by which shaders choose directions
// (shaders/scene/sky.glsl reads them).
//
// Equirectangular, +Y up, rows from the zenith down. The direction (x, y, z) is at
// u = 0.5 + atan2(z, x) / 2 pi, v = 0.5 - asin(y) / pi: the middle is +x, as in three.js and, after
// its import of glTF, in Blender.
#pragma once

#include <cstdint>
#include <vector>

#include "base/math.hpp"
#include "image/image.hpp"

namespace vitrine {

/// Radiance splits at `kBrightMultiple` times its mean: L = min(L, c) + max(L - c, 0). What is
/// above is a light, with shadows however far; what is below is ambient light.
inline constexpr float kBrightMultiple = 8;
/// Less than this share of the power above the limit is not worth a shadow ray.
inline constexpr float kLeastBrightShare = 0.05f;

/// One size of the picture, four half floats a texel, all / SkyMap::scale: the radiance below the
/// limit, and the luminance of what is above it, which has the same colour. Both are amounts, so
/// that filters keep them; a share would not be kept.
struct SkyLevel {
    int width = 0, height = 0;
    std::vector<uint16_t> texels;
};

/// Chooses among 2^levels x 2^(levels - 1) cells of equal angles, rows from the zenith down. A node
/// holds the probabilities of its four children: left and right of the upper row, then of the lower
/// one. Level k has 2^k x 2^(k - 1) nodes row by row; level 0 has one, without a lower row.
struct SkyTree {
    int levels = 0;
    std::vector<glm::vec4> nodes;
};

struct SkyMap {
    std::vector<SkyLevel> levels;
    float scale = 1;          ///< of the texels, which may not exceed what half floats hold
    glm::vec3 mean{0};        ///< radiance over all directions
    float brightShare = 0;    ///< of the power; 0 if no part is to be sampled
    SkyTree bright, whole;    ///< by the power above the limit, and by all of it
    size_t mendedTexels = 0;  ///< were not finite or negative
};

/// The picture must not be empty. Larger ones than kMostSkyWidth are stored smaller.
SkyMap makeSkyMap(const ImageRgba32f& picture);
inline constexpr int kMostSkyWidth = 4096;

/// Unit direction of a point of the picture; u and v in [0, 1] from the upper left.
glm::vec3 skyDirection(float u, float v);

/// The mean over all directions of the picture's luminance.
float luminance(const glm::vec3& radiance);

}  // namespace vitrine
