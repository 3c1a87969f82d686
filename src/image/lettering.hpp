// SPDX-License-Identifier: MIT
// Small words in pictures, for legends: letters of five by seven pixels.
#pragma once

#include <string_view>

#include "base/math.hpp"
#include "image/image.hpp"

namespace vitrine {

inline constexpr int kLetterWidth = 6, kLetterHeight = 8;  // with the space to the next

/// Writes from the upper left corner (x, y) on, each dot `scale` pixels wide. Capitals come out
/// small; signs there are no letters for are left out; what is outside of the picture is too.
void writeText(ImageRgba8& image, int x, int y, int scale, const glm::u8vec3& color,
               std::string_view text);

/// Its width in pixels.
int textWidth(std::string_view text, int scale);

}  // namespace vitrine
