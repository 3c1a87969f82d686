// SPDX-License-Identifier: MIT
// The hit record in C++: the text that GLSL compiles, compiled again.
#pragma once

#include <glm/packing.hpp>

#include "base/math.hpp"
#include "shared/limits.glsl"

namespace vitrine::record {

using glm::abs;
using glm::floatBitsToUint;
using glm::normalize;
using glm::packSnorm2x16;
using glm::packUnorm2x16;
using glm::uintBitsToFloat;
using glm::unpackSnorm2x16;
using glm::unpackUnorm2x16;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using uint = glm::uint;

#define VITRINE_INLINE inline
#include "shared/hit_record.glsl"
#undef VITRINE_INLINE

}  // namespace vitrine::record
