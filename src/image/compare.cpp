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

Comparison compareLinear(const ImageRgba32f& a, const ImageRgba32f& b, int tolerance) {
    Comparison result = compareImages(srgbFromLinear(a), srgbFromLinear(b), tolerance);
    double squares = 0;
    result.maxDifference = 0;
    for (size_t i = 0; i < a.pixels.size(); i += 4) {
        double here = 0, largestHere = 0;
        for (size_t channel = 0; channel < 4; ++channel) {
            const double difference =
                std::abs(double{a.pixels[i + channel]} - double{b.pixels[i + channel]});
            largestHere = std::max(largestHere, difference);
            // Not by largestHere: max() would lose a NaN.
            if (channel < 3 || !std::isfinite(difference)) here += difference * difference;
        }
        if (std::isfinite(here)) {
            squares += here;
            result.maxDifference = std::max(result.maxDifference, largestHere);
        } else {
            ++result.pixelsNotFinite;
        }
    }
    const size_t finite = result.pixels - result.pixelsNotFinite;
    result.rmse = finite > 0 ? std::sqrt(squares / (3.0 * static_cast<double>(finite))) : 0;
    result.psnr = -20.0 * std::log10(result.rmse);
    result.pixelsOver = std::min(result.pixels, result.pixelsOver + result.pixelsNotFinite);
    result.fractionOver = result.pixels > 0 ? static_cast<double>(result.pixelsOver) /
                                                  static_cast<double>(result.pixels)
                                            : 0;
    return result;
}

ImageRgba8 srgbFromLinear(const ImageRgba32f& image) {
    ImageRgba8 result(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        float x = image.pixels[i];
        x = x > 0 ? std::min(x, 1.0f) : 0.0f;  // NaN is not above 0
        if (i % 4 != 3)
            x = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
        result.pixels[i] = static_cast<uint8_t>(255.0f * x + 0.5f);
    }
    return result;
}

}  // namespace vitrine
