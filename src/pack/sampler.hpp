// SPDX-License-Identifier: MIT
// The sampler in C++: the text that GLSL compiles, compiled again.
#pragma once

#include "base/math.hpp"
#include "shared/limits.glsl"

namespace vitrine::sampler {

using glm::bitfieldReverse;
using glm::floatBitsToUint;
using glm::max;
using glm::uvec2;
using glm::uvec4;
using uint = glm::uint;

#define VITRINE_INLINE inline
#define DIALECT_ES 0
#include "shared/sampler.glsl"
#undef DIALECT_ES
#undef VITRINE_INLINE

}  // namespace vitrine::sampler
