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
    ImageMap flipMap;
};

/// Throws InputError if the pictures differ in size.
Comparison compareImages(const ImageRgba8& a, const ImageRgba8& b,
                         int tolerance = kDefaultTolerance);

}  // namespace vitrine
