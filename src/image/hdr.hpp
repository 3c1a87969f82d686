// SPDX-License-Identifier: MIT
// Radiance pictures (.hdr, .pic): radiance as three 8-bit mantissas with one exponent a pixel.
// Ward, "Real Pixels", Graphics Gems II, 1991, and the file format of the Radiance manual.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "image/image.hpp"

namespace vitrine {

/// Begins as a Radiance picture does.
bool isHdr(std::span<const uint8_t> bytes);

/// Linear RGB, alpha 1, divided by the exposure that the header names; black stays black. Pixels
/// plain, or compressed by the older or the newer of the format's two ways; rows from either side.
/// All values are finite. Throws InputError, placed at `file` and a byte in it, if the file is cut
/// short or damaged, holds XYZ colours, stands on its side, or is larger than kMaxHdrPixels; size
/// and header are looked at before any memory is asked for.
ImageRgba32f decodeHdr(std::span<const uint8_t> bytes, const std::string& file);

/// 8192 x 4096: half a gigabyte as floats.
inline constexpr uint64_t kMaxHdrPixels = 8192u * 4096u;

}  // namespace vitrine
