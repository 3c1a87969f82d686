// SPDX-License-Identifier: MIT
// Mesa's preprocessor folds white space before it counts columns, so there is never more than one
// space here: its columns are then ours, and originalColumn can find the user's.
#include "sdf/emit.hpp"

namespace vitrine {

namespace {

using Role = SnippetPiece::Role;

std::string textOf(const SnippetPiece& piece, const Snippet& snippet, const EmitOptions& options) {
    switch (piece.role) {
        case Role::kText:
            return piece.text;
        case Role::kName:
            return emittedName(options.prefix, piece.text);
        case Role::kParameter:
            return options.parameter(snippet.parameters[static_cast<size_t>(piece.index)],
                                     piece.index);
        case Role::kBuiltin: {
            const auto found = options.builtins.find(piece.text);
            return found == options.builtins.end() ? piece.text : found->second;
        }
        case Role::kGuard:
            return options.loopGuard;
    }
    return {};
}

/// `visit(piece, text, column)` for each piece, after the line breaks or space before it were
/// added.
template <class Visit>
std::string write(const Snippet& snippet, const EmitOptions& options, Visit visit) {
    // From here on a "#line" is shorter than the empty lines.
    constexpr int kMaxEmptyLines = 4;
    std::string result;
    int line = 0;
    size_t lineStart = 0;
    for (const SnippetPiece& piece : snippet.pieces) {
        if (line == 0 || piece.line > line + kMaxEmptyLines) {
            if (line > 0) result += '\n';
            result += "#line " + std::to_string(options.lineBase + piece.line) + '\n';
            line = piece.line;
            lineStart = result.size();
        } else if (piece.line > line) {
            result.append(static_cast<size_t>(piece.line - line), '\n');
            line = piece.line;
            lineStart = result.size();
        } else if (piece.spaceBefore) {
            result += ' ';
        }
        const std::string text = textOf(piece, snippet, options);
        visit(piece, line, static_cast<int>(result.size() - lineStart) + 1);
        result += text;
    }
    result += '\n';
    return result;
}

}  // namespace

std::string emitSnippet(const Snippet& snippet, const EmitOptions& options) {
    return write(snippet, options, [](const SnippetPiece&, int, int) {});
}

std::string emittedName(const std::string& prefix, const std::string& name) {
    // "s0_" and "_a" would make two underscores in a row, which GLSL reserves. No name of a user
    // begins with a digit, so "s0_0_a" is nobody else's.
    return prefix + (name.starts_with('_') ? "0" : "") + name;
}

int originalColumn(const Snippet& snippet, const EmitOptions& options, int line, int column) {
    int found = 0;
    write(snippet, options, [&](const SnippetPiece& piece, int at, int emittedColumn) {
        if (at == line && (found == 0 || emittedColumn <= column)) found = piece.column;
    });
    return found;
}

}  // namespace vitrine
