// SPDX-License-Identifier: MIT
// Pictures of a scene in the pages of two texture arrays: colours (sRGB) and data (linear).
//
// Rays need any texture at any hit, and GLSL without bindless textures cannot choose a sampler by
// number. So all pictures lie in pages, and so does each smaller version of them that is needed to
// look at them from afar. Around each lies a border of one texel that repeats or clamps as the
// texture does, so that the hardware's bilinear filter is right up to the edge.
//
// Sides are powers of two (others are resampled): a level's size is a shift.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// How the channels are meant: colours are stored and averaged as light.
enum class TextureUse { kColor, kData };

/// The first texel of a level, inside its border.
struct LevelPlace {
    int page = 0, x = 0, y = 0;
};

struct TexturePlace {
    int log2Width = 0, log2Height = 0;
    std::vector<LevelPlace> levels;  ///< each half as wide and high as the one before
    TextureWrap wrapU = TextureWrap::kRepeat, wrapV = TextureWrap::kRepeat;
    bool nearest = false;
};

/// A square page; rows from the top of the pictures downwards.
struct TexturePage {
    int size = 0;
    std::vector<uint8_t> texels;  ///< RGBA
};

struct TextureRequest {
    const ImageRgba8* image = nullptr;
    TextureWrap wrapU = TextureWrap::kRepeat, wrapV = TextureWrap::kRepeat;
    bool nearest = false;  ///< only handed on
};

struct TextureAtlas {
    std::vector<TexturePlace> places;  ///< one a request
    std::vector<TexturePage> pages;    ///< all of one size
    /// Pictures that were made smaller to fit `kLargestTexture`.
    size_t reduced = 0;
};

inline constexpr int kLargestTexture = 2048;

/// Packs the pictures. Deterministic.
TextureAtlas packTextures(std::span<const TextureRequest> requests, TextureUse use);

}  // namespace vitrine
