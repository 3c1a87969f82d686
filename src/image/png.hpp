// SPDX-License-Identifier: MIT
// PNG files in memory, through libpng. Writing to disk is base/file.hpp's part.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace vitrine {

struct PngTextEntry {
    std::string key;    // 1 to 79 ASCII characters, such as "Software" or "Description"
    std::string value;  // UTF-8
};
using PngText = std::vector<PngTextEntry>;

/// An sRGB PNG of 8 bits a channel, without alpha if all pixels are opaque. The same picture and
/// text give the same bytes (with the same zlib). The picture must not be empty.
std::vector<uint8_t> encodePng(const ImageRgba8& image, const PngText& text = {});

/// Any PNG as RGBA8: palettes, greys, 16 bits, transparency and interlacing are converted. Colour
/// values are taken as sRGB, whatever gamma or profile the file names.
/// Throws InputError, placed at `file` and a byte in it, if the file is cut short, damaged anywhere
/// (every checksum counts) or larger than kMaxImageSide, or if its header promises more pixels than
/// its bytes can hold. Both sizes are looked at before any memory is asked for.
ImageRgba8 decodePng(std::span<const uint8_t> bytes, const std::string& file);

/// What the header says, under the same checks, without decoding.
ImageSize pngSize(std::span<const uint8_t> bytes, const std::string& file);

}  // namespace vitrine
