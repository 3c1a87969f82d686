// SPDX-License-Identifier: MIT
// Pictures in memory: rows from top to bottom, pixels from left to right, channels side by side.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vitrine {

/// No picture from outside may be wider or higher. Hence at most 268 million pixels, 1 GiB as
/// RGBA8.
inline constexpr int kMaxImageSide = 16384;

struct ImageSize {
    int width = 0;
    int height = 0;
    [[nodiscard]] uint64_t pixelCount() const { return static_cast<uint64_t>(width) * height; }
    bool operator==(const ImageSize&) const = default;
};

template <typename T, int channels>
struct Image {
    static constexpr int kChannels = channels;

    int width = 0;
    int height = 0;
    std::vector<T> pixels;

    Image() = default;
    Image(int w, int h) : Image(w, h, std::vector<T>(static_cast<size_t>(w) * h * channels)) {}
    Image(int w, int h, std::vector<T> values) : width(w), height(h), pixels(std::move(values)) {
        assert(w >= 0 && h >= 0 && pixels.size() == pixelCount() * channels);
    }

    [[nodiscard]] size_t pixelCount() const { return static_cast<size_t>(width) * height; }
    /// The channels of one pixel; (0, 0) is the top left one.
    [[nodiscard]] std::span<T, channels> at(int x, int y) {
        return std::span<T, channels>(pixels.data() + offset(x, y), channels);
    }
    [[nodiscard]] std::span<const T, channels> at(int x, int y) const {
        return std::span<const T, channels>(pixels.data() + offset(x, y), channels);
    }
    [[nodiscard]] std::span<T> row(int y) {
        return {pixels.data() + offset(0, y), static_cast<size_t>(width) * channels};
    }
    [[nodiscard]] std::span<const T> row(int y) const {
        return {pixels.data() + offset(0, y), static_cast<size_t>(width) * channels};
    }
    bool operator==(const Image&) const = default;

  private:
    [[nodiscard]] size_t offset(int x, int y) const {
        assert(x >= 0 && x < width && y >= 0 && y < height);
        return (static_cast<size_t>(y) * width + x) * channels;
    }
};

using ImageRgba8 = Image<uint8_t, 4>;  // sRGB colour, straight alpha
using ImageRgba32f = Image<float, 4>;  // linear colour
using ImageMap = Image<float, 1>;      // one number a pixel: an error, a count, a depth

}  // namespace vitrine
