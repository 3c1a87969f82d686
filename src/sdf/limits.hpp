// SPDX-License-Identifier: MIT
// How much of everything a snippet may have. Shader compilers cannot be cancelled and take minutes
// and gigabytes for ten hostile lines, so these are checked before any compiler sees the text.
// Each limit is several times what the largest honest Shadertoy or Fragmentarium files need.
#pragma once

#include <cstddef>

namespace vitrine::glsl {

inline constexpr size_t kMaxSourceBytes = 64 * 1024;
inline constexpr size_t kMaxTokens = 20'000;
/// Tokens made while expanding macros, intermediate ones included: bounds the work, not only the
/// text.
inline constexpr size_t kMaxExpansion = 40'000;
/// Macro arguments that hold macro calls that hold ... Each level is one level of our own stack.
inline constexpr int kMaxMacroDepth = 64;
inline constexpr size_t kMaxNameLength = 200;
/// Brackets and statements inside of each other.
inline constexpr int kMaxNesting = 64;
inline constexpr size_t kMaxFunctions = 300;
inline constexpr int kMaxParameters = 64;
inline constexpr int kMaxArrayLength = 1024;
/// Floats in all arrays of a snippet together. Functions are inlined, so locals add up.
inline constexpr int kMaxArrayFloats = 16 * 1024;
/// Later errors are mostly consequences of earlier ones.
inline constexpr int kMaxProblems = 30;

}  // namespace vitrine::glsl
