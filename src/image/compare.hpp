// SPDX-License-Identifier: MIT
// How far two pictures are apart: by arithmetic, by counting pixels, and to the eye.
#pragma once

#include <cstddef>

#include "image/image.hpp"

namespace vitrine {

/// In 1/255 of a channel. With at most 0.1 % of the pixels over it: the bound that Filament's image
/// tests use on one software driver, where pictures differ only by rounding.
inline constexpr int kDefaultTolerance = 5;

struct Comparison {
    double rmse = 0.0;           // over red, green and blue, which count from 0 to 1
    double psnr = 0.0;           // dB below full scale; infinite if red, green and blue are equal
    double flipMean = 0.0;       // 0 looks the same, 1 could not differ more; see flip.hpp
    double maxDifference = 0.0;  // of any channel, alpha too; 0 to 1
    size_t pixels = 0;
    size_t pixelsOver = 0;  // pixels with any channel, alpha too, off by more than the tolerance
    double fractionOver = 0.0;
    size_t pixelsNotFinite = 0;  // of linear pictures; they count as over, and not in the errors
    ImageMap flipMap;
};

/// Throws InputError if the pictures differ in size.
Comparison compareImages(const ImageRgba8& a, const ImageRgba8& b,
                         int tolerance = kDefaultTolerance);

/// Linear pictures: rmse, psnr (of full scale 1) and the largest difference are those of linear
/// values; pixels over the tolerance and FLIP are those of the pictures in sRGB, clamped to [0, 1].
/// Throws InputError if the pictures differ in size.
Comparison compareLinear(const ImageRgba32f& a, const ImageRgba32f& b,
                         int tolerance = kDefaultTolerance);

/// Linear colour in sRGB, clamped to [0, 1] and rounded; NaN becomes 0.
ImageRgba8 srgbFromLinear(const ImageRgba32f& image);

}  // namespace vitrine
