// SPDX-License-Identifier: MIT
// A file of the library is read like a snippet: by the same lexer and parser, under the same
// limits, with the same guards in its loops.
#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"
#include "sdf/brackets.hpp"
#include "sdf/call_graph.hpp"
#include "sdf/library.hpp"
#include "sdf/parser.hpp"
#include "sdf/preprocessor.hpp"

namespace vitrine {

namespace {

/// The text in "name[text]", if `line` is that.
std::optional<std::string> claim(std::string_view line, std::string_view name) {
    if (!startsWith(line, name) || !endsWith(line, "]")) return {};
    line.remove_prefix(name.size());
    if (!startsWith(line, "[")) return {};
    return std::string(trim(line.substr(1, line.size() - 2)));
}

/// A line of the comment above a function. Prose goes to the part that was begun last.
void readCommentLine(std::string_view line, LibraryFunction& function, bool& inSource) {
    line = trim(line);
    using Quality = LibraryFunction::Quality;
    if (line == "exact") {
        function.quality = Quality::kExact;
    } else if (line == "exact inside") {
        function.quality = Quality::kExactInside;
    } else if (line == "exact outside") {
        function.quality = Quality::kExactOutside;
    } else if (line == "bound") {
        function.quality = Quality::kBound;
    } else if (const auto slope = claim(line, "lipschitz")) {
        function.lipschitz = *slope;
    } else if (const auto box = claim(line, "bounds")) {
        function.bounds = *box;
    } else if (const auto example = claim(line, "example")) {
        function.examples.push_back(*example);
    } else if (const auto pattern = claim(line, "pattern")) {
        function.patterns.push_back(*pattern);
    } else if (const auto shape = claim(line, "shape")) {
        function.shape = *shape;
    } else {
        if (startsWith(line, "Source: ")) {
            inSource = true;
            line.remove_prefix(8);
        }
        std::string& text = inSource ? function.source : function.about;
        text += (text.empty() ? "" : " ") + std::string(line);
    }
}

/// The comments that stand directly above `line`.
void readComments(const std::vector<glsl::Comment>& comments, int line, LibraryFunction& function) {
    auto last = std::find_if(comments.rbegin(), comments.rend(),
                             [&](const glsl::Comment& c) { return c.place.line == line - 1; });
    auto first = last;
    while (first != comments.rend() && first->startsLine && first->place.line == line - 1) {
        ++first;
        --line;
    }
    bool inSource = false;
    for (auto comment = first.base(); comment != last.base(); ++comment)
        readCommentLine(comment->text, function, inSource);
}

std::string signatureOf(const std::vector<SnippetPiece>& pieces) {
    std::string text;
    for (const SnippetPiece& piece : pieces) {
        if (piece.text == "{") break;
        if (piece.spaceBefore && !text.empty()) text += ' ';
        text += piece.text;
    }
    return text;
}

}  // namespace

void Library::read(const std::string& folder, const EmbeddedFile& file) {
    Snippet snippet;
    snippet.file = folder + std::string(file.name);
    snippet.source = std::string(file.text);
    Diagnostics diagnostics;
    glsl::Problems problems(diagnostics, snippet.file);
    glsl::Preprocessed text = glsl::preprocess(glsl::lex(snippet.source), problems);
    const std::vector<glsl::Comment> comments = std::move(text.comments);
    text.comments.clear();
    glsl::UniformNotes notes(text, snippet, problems);
    const auto partner = glsl::matchBrackets(text.tokens, problems);
    if (!partner) throw std::logic_error(diagnostics.text());
    glsl::Parser parser(text.tokens, *partner, notes, *this, snippet, problems);
    parser.run();
    glsl::checkCalls(parser.functions(), problems);

    const size_t base = functions_.size();
    for (const glsl::Function& read : parser.functions()) {
        LibraryFunction function;
        function.name = read.name;
        function.argumentCount = read.arguments.size();
        function.where = problems.at(read.place);
        function.pieces.assign(snippet.pieces.begin() + static_cast<long>(read.firstPiece),
                               snippet.pieces.begin() + static_cast<long>(read.lastPiece));
        function.signature = signatureOf(function.pieces);
        readComments(comments, read.place.line, function);
        for (const glsl::Function::Call& call : read.calls)
            function.calls.push_back(base + call.callee);
        for (const std::string& name : read.libraryCalls)
            function.calls.push_back(static_cast<size_t>(find(name) - functions_.data()));
        if (find(function.name) != nullptr)
            problems.error(read.place, "'" + function.name + "' exists already");
        functions_.push_back(std::move(function));
    }
    if (problems.failed()) throw std::logic_error(diagnostics.text());
}

}  // namespace vitrine
