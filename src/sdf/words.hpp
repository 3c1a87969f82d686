// SPDX-License-Identifier: MIT
// The words of GLSL that reading a snippet has to know, and what snippets may not use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vitrine::glsl {

/// Number of floats (or integers) in a value of a built-in type; 0 if it is not one.
int builtinTypeSize(std::string_view word);
/// const, in, out, inout and the precisions.
bool isQualifier(std::string_view word);
/// Storage that only a whole shader may declare: uniform blocks, inputs, layouts.
bool isShaderInterface(std::string_view word);
/// if, for, return ...: words that begin a statement.
bool isStatementWord(std::string_view word);
/// Any word that cannot be a name.
bool isReserved(std::string_view word);

/// A function that GLSL ES 3.00 and GLSL 4.10 share, textures and derivatives apart.
bool isBuiltinFunction(std::string_view word);
const std::vector<std::string>& builtinFunctions();

/// Why a built-in name may not be used in a snippet, as a sentence; empty if it may.
std::string_view reasonAgainst(std::string_view name);

}  // namespace vitrine::glsl
