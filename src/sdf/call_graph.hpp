// SPDX-License-Identifier: MIT
// GLSL has no recursion; drivers differ in how they say so, or crash.
#pragma once

#include <span>

#include "sdf/kinds.hpp"
#include "sdf/problems.hpp"

namespace vitrine::glsl {

/// Reports each call that closes a circle, and functions that are called but have no body.
void checkCalls(std::span<const Function> functions, Problems& problems);

}  // namespace vitrine::glsl
