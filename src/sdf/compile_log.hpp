// SPDX-License-Identifier: MIT
// From a GLSL compiler's log back to the user's file, line and column.
//
// Mesa forgets the source number of "#line" in some messages but never the line, so the snippet is
// encoded in the line number: snippet k begins at lineBaseOf(k).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "sdf/emit.hpp"

namespace vitrine {

/// Above any number of lines that a snippet may have; our own shaders stay below the first base.
inline constexpr int kLinesPerSnippet = 100'000;
constexpr int lineBaseOf(int snippet) {
    return kLinesPerSnippet * (snippet + 1);
}

struct CompileMessage {
    Severity severity = Severity::kError;
    /// Second number after "#line N S"; 0 if unknown.
    int source = 0;
    int line = 0;
    /// 0 if the compiler does not say.
    int column = 0;
    std::string message;
};

/// The messages with a line of a log by Mesa "0:12(7): error: ...", NVIDIA "0(12) : error C1008:
/// ..." or ANGLE, glslang, Apple, AMD and Intel "ERROR: 0:12: ...". Other lines are skipped.
std::vector<CompileMessage> parseCompileLog(std::string_view log);

struct SnippetLine {
    int snippet = 0;
    int line = 0;
};

/// Which snippet, and which of its lines, a compiler's line is. `lineBases` need no order.
std::optional<SnippetLine> mapToSnippet(int line, std::span<const int> lineBases);

struct SnippetInProgram {
    const Snippet* snippet = nullptr;
    const EmitOptions* options = nullptr;
};

/// The message in the user's terms: place in the file, names without prefixes. Nothing if its line
/// is in none of the snippets.
std::optional<Diagnostic> explainMessage(const CompileMessage& message,
                                         std::span<const SnippetInProgram> snippets);

}  // namespace vitrine
