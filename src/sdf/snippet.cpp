// SPDX-License-Identifier: MIT
// The steps in order: limits, lexer, preprocessor, brackets, annotations, parser, calls, entry.
#include "sdf/snippet.hpp"

#include <utility>

#include "sdf/brackets.hpp"
#include "sdf/call_graph.hpp"
#include "sdf/lexer.hpp"
#include "sdf/library.hpp"
#include "sdf/limits.hpp"
#include "sdf/parser.hpp"
#include "sdf/preprocessor.hpp"
#include "sdf/problems.hpp"
#include "sdf/uniform_notes.hpp"

namespace vitrine {

namespace {

void read(Snippet& snippet, glsl::Problems& problems) {
    if (snippet.source.size() > glsl::kMaxSourceBytes) {
        problems.error({1, 1}, std::to_string(snippet.source.size()) +
                                   " bytes; a snippet has at most " +
                                   std::to_string(glsl::kMaxSourceBytes));
        return;
    }
    glsl::LexedText lexed = glsl::lex(snippet.source);
    if (lexed.openComment.line > 0) {
        problems.error(lexed.openComment, "nothing closes this comment");
        return;
    }
    if (lexed.tokens.size() > glsl::kMaxTokens) {
        problems.error(lexed.tokens[glsl::kMaxTokens].place,
                       "more than " + std::to_string(glsl::kMaxTokens) + " words and signs");
        return;
    }
    const glsl::Preprocessed text = glsl::preprocess(std::move(lexed), problems);
    if (text.abandoned) return;
    glsl::UniformNotes notes(text, snippet, problems);
    const auto partner = glsl::matchBrackets(text.tokens, problems);
    if (!partner) return;
    glsl::Parser parser(text.tokens, *partner, notes, sdfLibrary(), snippet, problems);
    parser.run();
    glsl::checkCalls(parser.functions(), problems);
    glsl::chooseEntry(parser.functions(), snippet, problems);
    if (!problems.failed() && !snippet.partNames.empty() && !snippet.entryReturnsPart)
        problems.warning({1, 1}, "parts[...] has no effect: '" + snippet.entry +
                                     "' returns only a distance, not vec2(distance, part)");
}

}  // namespace

int componentCount(ParameterType type) {
    switch (type) {
        case ParameterType::kVec2:
            return 2;
        case ParameterType::kVec3:
        case ParameterType::kColor:
            return 3;
        case ParameterType::kVec4:
            return 4;
        default:
            return 1;
    }
}

std::string_view glslName(ParameterType type) {
    switch (type) {
        case ParameterType::kFloat:
            return "float";
        case ParameterType::kInt:
            return "int";
        case ParameterType::kBool:
            return "bool";
        case ParameterType::kVec2:
            return "vec2";
        case ParameterType::kVec3:
        case ParameterType::kColor:
            return "vec3";
        case ParameterType::kVec4:
            return "vec4";
    }
    return "float";
}

std::optional<Snippet> parseSnippet(std::string_view source, const std::string& file,
                                    SnippetKind kind, Diagnostics& diagnostics) {
    Snippet snippet;
    snippet.file = file;
    snippet.kind = kind;
    snippet.source = std::string(source);
    // Some editors on Windows begin a file with it; it is no part of the text.
    if (snippet.source.starts_with("\xEF\xBB\xBF")) snippet.source.replace(0, 3, "   ");
    glsl::Problems problems(diagnostics, file);
    read(snippet, problems);
    if (problems.failed()) return {};
    return snippet;
}

}  // namespace vitrine
