// SPDX-License-Identifier: MIT
// The lines that begin with #: conditionals and macros are carried out, the rest is refused.
#pragma once

#include <string>
#include <vector>

#include "sdf/lexer.hpp"
#include "sdf/problems.hpp"
#include "sdf/token.hpp"

namespace vitrine::glsl {

/// "#group Shape", Fragmentarium's way to head the uniforms that follow.
struct GroupLine {
    int line = 0;
    std::string name;
};

struct Preprocessed {
    Tokens tokens;                  // without macros and # lines; the last one is kEnd
    std::vector<Comment> comments;  // those that no #if skips
    std::vector<GroupLine> groups;
    /// A limit was hit; what follows would be guesswork.
    bool abandoned = false;
};

/// VITRINE is defined as 1 and __VERSION__ as 300, the version that all targets understand.
Preprocessed preprocess(LexedText text, Problems& problems);

}  // namespace vitrine::glsl
