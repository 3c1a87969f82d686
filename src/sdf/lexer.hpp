// SPDX-License-Identifier: MIT
// Splits GLSL text into tokens and comments. Never fails: what it cannot read becomes kOther.
#pragma once

#include <string_view>
#include <vector>

#include "sdf/token.hpp"

namespace vitrine::glsl {

struct LexedText {
    Tokens tokens;  // the last one is kEnd, placed on the last line
    std::vector<Comment> comments;
    /// Where a "/*" stands that nothing closes; line 0 if there is none.
    Place openComment{0, 0};
};

LexedText lex(std::string_view source);

}  // namespace vitrine::glsl
