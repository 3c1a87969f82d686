// SPDX-License-Identifier: MIT
// Integer constant expressions, as in "#if" and in the length of an array.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "sdf/token.hpp"

namespace vitrine::glsl {

using NameValue = std::function<std::optional<int64_t>(const Token& name)>;

/// The value, or nothing if it is no such expression, overflows, divides by zero, or holds a name
/// without a value.
std::optional<int64_t> evaluateConstant(std::span<const Token> tokens, const NameValue& valueOf);

/// The value of a literal such as 16, 0x10, 020 or 16u.
std::optional<int64_t> integerLiteral(std::string_view text);

}  // namespace vitrine::glsl
