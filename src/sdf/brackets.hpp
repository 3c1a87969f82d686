// SPDX-License-Identifier: MIT
// Which bracket closes which. With this known, no later step can run past the end of a block.
#pragma once

#include <optional>
#include <vector>

#include "sdf/problems.hpp"
#include "sdf/token.hpp"

namespace vitrine::glsl {

/// For each token that is a bracket, the index of its partner; for the others, its own index.
/// Nothing if they do not pair up or nest too deeply, which is reported.
std::optional<std::vector<size_t>> matchBrackets(const Tokens& tokens, Problems& problems);

}  // namespace vitrine::glsl
