// SPDX-License-Identifier: MIT
// OpenEXR files in memory, through OpenEXR 3. Writing to disk is base/file.hpp's part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "image/image.hpp"

namespace vitrine {

/// No EXR may have more pixels: 16384 x 8192, 2 GiB as RGBA32f.
inline constexpr uint64_t kMaxExrPixels = uint64_t{1} << 27;

/// The channels R, G, B (or Y, as grey) and A (or 1) of the display window, with zeros where the
/// file has no data. Any compression, half, float or whole numbers, scan lines or tiles; of a file
/// of several parts the first. Values are as stored: they may be negative, infinite or NaN.
/// Throws InputError, placed at `file`, if the file is cut short or damaged (as far as the format,
/// which has few checksums, can tell), too large, deep, has none of these channels or stores colour
/// at less than full resolution. Sizes are looked at before memory is asked for.
ImageRgba32f decodeExr(std::span<const uint8_t> bytes, const std::string& file);

/// Size of the display window by the header alone, under the same checks.
ImageSize exrSize(std::span<const uint8_t> bytes, const std::string& file);

enum class ExrReal { kHalf, kFloat };

/// One channel of a file to be written. Value (x, y) is number `(y * width + x) * stride` of
/// `values`, which is the caller's memory.
struct ExrChannel {
    std::string name;  // "R", "albedo.R": a layer is what stands before the last point
    std::variant<std::span<const float>, std::span<const uint32_t>> values;
    size_t stride = 1;
    ExrReal real = ExrReal::kFloat;  // how floats are stored; half ends at 65504
};

using ExrText = std::vector<std::pair<std::string, std::string>>;

/// Scan lines, compressed with ZIP. The same values give the same bytes (with the same OpenEXR).
/// The names must differ, and the picture must not be empty.
std::vector<uint8_t> encodeExr(ImageSize size, const std::vector<ExrChannel>& channels,
                               const ExrText& text = {});

}  // namespace vitrine
