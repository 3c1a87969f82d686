// SPDX-License-Identifier: MIT
// Picture files of any format that Vitrine reads, told apart by their first bytes: a name's ending
// and a declared type may lie.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "image/image.hpp"

namespace vitrine {

enum class ImageFormat { kUnknown, kPng, kJpeg, kExr };

ImageFormat imageFormat(std::span<const uint8_t> bytes);

/// A PNG or JPEG as sRGB pixels. Throws InputError, placed at `file`; see png.hpp and jpeg.hpp. An
/// EXR has linear light instead and is refused; see exr.hpp.
ImageRgba8 decodeImage(std::span<const uint8_t> bytes, const std::string& file);

/// Width and height by the header alone, which may still lie about what follows; neither is over
/// kMaxImageSide. Throws InputError, placed at `file`.
ImageSize imageSize(std::span<const uint8_t> bytes, const std::string& file);

}  // namespace vitrine
