// SPDX-License-Identifier: MIT
// The hit record in C++: the text that GLSL compiles, compiled again.
#pragma once

#include "base/math.hpp"
#include "shared/limits.glsl"

namespace vitrine::record {

using glm::abs;
using glm::clamp;
using glm::floatBitsToUint;
using glm::normalize;
using glm::uintBitsToFloat;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using uint = glm::uint;

#define VITRINE_INLINE inline
#include "shared/hit_record.glsl"
#undef VITRINE_INLINE

}  // namespace vitrine::record
