// SPDX-License-Identifier: MIT
// The GLSL that a scene adds to the shaders: its fields and material snippets, and the one place
// each of them is called from.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sdf/compile_log.hpp"
#include "sdf/emit.hpp"

namespace vitrine {

/// A snippet in the generated text, for leading compiler messages back.
struct EmittedSnippet {
    std::shared_ptr<const Snippet> snippet;
    EmitOptions options;
};

struct GeneratedShaders {
    /// By include name: "generated/field.glsl", "generated/material.glsl".
    std::map<std::string, std::string> includes;
    std::vector<EmittedSnippet> snippets;
};

/// Field i of `fields` answers to shape i, material snippet i to number i + 1 (0 is none).
GeneratedShaders generateShaders(const std::vector<std::shared_ptr<const Snippet>>& fields,
                                 const std::vector<std::shared_ptr<const Snippet>>& materials);

}  // namespace vitrine
