// SPDX-License-Identifier: MIT
#include "image/compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "image/flip.hpp"

namespace vitrine {

Comparison compareImages(const ImageRgba8& a, const ImageRgba8& b, int tolerance) {
    // First, because it refuses pictures of different sizes.
    FlipResult flipped = flip(a, b);

    Comparison result;
    result.flipMean = flipped.mean;
    result.flipMap = std::move(flipped.map);
    result.pixels = a.pixelCount();
    if (result.pixels == 0) {
        result.psnr = std::numeric_limits<double>::infinity();
        return result;
    }

    uint64_t squares = 0;  // whole numbers: exact, whatever the order
    int largest = 0;
    for (size_t i = 0; i < a.pixels.size(); i += 4) {
        int largestHere = 0;
        for (size_t channel = 0; channel < 4; ++channel) {
            const int difference = std::abs(a.pixels[i + channel] - b.pixels[i + channel]);
            largestHere = std::max(largestHere, difference);
            if (channel < 3) squares += static_cast<uint64_t>(difference * difference);
        }
        largest = std::max(largest, largestHere);
        if (largestHere > tolerance) ++result.pixelsOver;
    }
    const double count = static_cast<double>(result.pixels);
    result.rmse = std::sqrt(static_cast<double>(squares) / (3.0 * count)) / 255.0;
    result.psnr = -20.0 * std::log10(result.rmse);
    result.maxDifference = largest / 255.0;
    result.fractionOver = static_cast<double>(result.pixelsOver) / count;
    return result;
}

}  // namespace vitrine
