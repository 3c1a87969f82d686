// SPDX-License-Identifier: MIT
// JPEG files in memory, through libjpeg-turbo. Only reading: pictures are written as PNG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "image/image.hpp"

namespace vitrine {

/// Any JPEG of 8 bits a channel as RGBA8, opaque: grey, colour, CMYK; baseline or progressive.
/// Values are taken as sRGB, whatever profile the file holds; its orientation note is ignored.
/// Throws InputError, placed at `file` and a byte in it, if the file is cut short, damaged (as far
/// as the format, which has no checksums, can tell), larger than kMaxImageSide, or if its header
/// promises more pixels than its bytes can hold. Sizes are looked at before memory is asked for.
ImageRgba8 decodeJpeg(std::span<const uint8_t> bytes, const std::string& file);

/// What the header says, under the same checks, without decoding.
ImageSize jpegSize(std::span<const uint8_t> bytes, const std::string& file);

}  // namespace vitrine
