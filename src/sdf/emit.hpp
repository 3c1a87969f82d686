// SPDX-License-Identifier: MIT
// Writes a snippet as GLSL that can stand beside others in one program.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "sdf/snippet.hpp"

namespace vitrine {

struct EmitOptions {
    /// Goes before every name that the snippet declares, local ones too: so no declaration of a
    /// user can capture a name of the expressions below. Ends in one underscore, holds no two.
    std::string prefix = "s0_";
    /// Line n of the user's file is line lineBase + n for the compiler (compile_log.hpp).
    int lineBase = 0;
    /// The expression that reads a parameter, of that parameter's GLSL type. It stands in any
    /// context, so it must be a call, a name, or in parentheses.
    std::function<std::string(const Parameter&, int index)> parameter;
    /// Expressions for what is built in, by key: "time" (float), and for screens "timeDelta"
    /// (float), "frame" (int), "resolution" (vec3), "mouse" (vec4), "date" (vec4). The same
    /// demands. What is missing here is emitted under its own key as the name.
    std::map<std::string, std::string, std::less<>> builtins;
    /// A bool expression: true if a loop may go round once more. Asked before every iteration.
    std::string loopGuard = "loopGuard()";
};

/// GLSL text from "#line" to a line end. The same input gives the same bytes. Comments, macros,
/// uniforms and precision statements are gone; every token stands on its line of the user's file.
std::string emitSnippet(const Snippet& snippet, const EmitOptions& options);

/// How a name that the snippet declares, `snippet.entry` for example, is called in the emitted
/// text.
std::string emittedName(const std::string& prefix, const std::string& name);

/// The column in the user's file of what stands in `column` of the emitted line for `line`.
/// 0 if nothing of the snippet stands on that line.
int originalColumn(const Snippet& snippet, const EmitOptions& options, int line, int column);

}  // namespace vitrine
