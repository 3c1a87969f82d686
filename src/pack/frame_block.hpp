// SPDX-License-Identifier: MIT
// The uniform block `frame` in C++: the fields that GLSL reads, read again.
#pragma once

#include "base/math.hpp"
#include "shared/limits.glsl"

namespace vitrine {

struct FrameBlock {
    using vec4 = glm::vec4;
    using ivec4 = glm::ivec4;
#include "shared/frame_fields.glsl"
};
static_assert(sizeof(FrameBlock) == 16 * 20, "std140: every field is 16 bytes, without padding");

}  // namespace vitrine
