// SPDX-License-Identifier: MIT
// Broken snippets: whatever happens to a text, reading it ends soon, throws nothing, and each
// message has a place inside of the file. The seeds are fixed, so a failure can be repeated.
#include <algorithm>
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "sdf/lexer.hpp"
#include "sdf/test_samples.hpp"
#include "sdf/test_support.hpp"

namespace vitrine {

namespace {

void check(const std::string& source, SnippetKind kind) {
    Diagnostics diagnostics;
    std::optional<Snippet> snippet;
    ASSERT_NO_THROW(snippet = parseSnippet(source, "f", kind, diagnostics)) << source;
    EXPECT_EQ(snippet.has_value(), !diagnostics.hasErrors()) << source;
    const auto lines = std::count(source.begin(), source.end(), '\n') + 1;
    for (const Diagnostic& d : diagnostics.list()) {
        EXPECT_GE(d.where.line, 1) << d.text() << "\n" << source;
        EXPECT_LE(d.where.line, lines) << d.text() << "\n" << source;
        EXPECT_GE(d.where.column, 1) << d.text() << "\n" << source;
    }
    if (!snippet) return;
    EmitOptions options = shortOptions();
    options.loopGuard = "unlikelyName()";
    const std::string text = emitSnippet(*snippet, options);
    // Each loop that comes out is guarded.
    int loops = 0, guards = 0;
    for (const glsl::Token& token : glsl::lex(text).tokens) {
        loops += token.is("for") || token.is("while") ? 1 : 0;
        guards += token.is("unlikelyName") ? 1 : 0;
    }
    EXPECT_EQ(loops, guards) << text;
}

std::string joined(const glsl::Tokens& tokens) {
    std::string text;
    int line = 1;
    for (const glsl::Token& token : tokens) {
        for (; line < token.place.line; ++line) text += '\n';
        text += token.text + ' ';
    }
    return text;
}

}  // namespace

TEST(Fuzz, EveryTruncation) {
    for (const Sample& sample : kSamples)
        for (size_t length = 0; length <= sample.source.size(); ++length)
            check(std::string(sample.source.substr(0, length)), sample.kind);
}

TEST(Fuzz, EveryMissingToken) {
    for (const Sample& sample : kSamples) {
        const glsl::Tokens tokens = glsl::lex(sample.source).tokens;
        for (size_t i = 0; i + 1 < tokens.size(); ++i) {
            glsl::Tokens broken = tokens;
            broken.erase(broken.begin() + static_cast<std::ptrdiff_t>(i));
            check(joined(broken), sample.kind);
        }
    }
}

TEST(Fuzz, RandomTokens) {
    constexpr std::array<const char*, 36> kWords = {
        "(",          ")",       "{",      "}",         "[",     "]",    ";",           ",",
        "=",          ".",       "for",    "while",     "do",    "if",   "else",        "switch",
        "case",       "uniform", "struct", "const",     "float", "sdf",  "p",           "time",
        "return",     "?",       ":",      "precision", "in",    "void", "\n#define p", "\n#if",
        "\n#endif\n", "\n",      "1025",   "//slider["};
    std::mt19937 random(20'240'229);
    const auto below = [&](size_t n) { return random() % n; };
    for (int round = 0; round < 4000; ++round) {
        const Sample& sample = kSamples[below(kSamples.size())];
        glsl::Tokens tokens = glsl::lex(sample.source).tokens;
        for (size_t changes = 1 + below(6); changes > 0; --changes) {
            glsl::Token& token = tokens[below(tokens.size())];
            if (below(2) == 0)
                token.text = kWords[below(kWords.size())];
            else
                std::swap(token.text, tokens[below(tokens.size())].text);
        }
        check(joined(tokens), sample.kind);
    }
}

TEST(Fuzz, RandomBytes) {
    std::mt19937 random(7);
    for (int round = 0; round < 4000; ++round) {
        const Sample& sample = kSamples[random() % kSamples.size()];
        std::string text(sample.source);
        for (size_t changes = 1 + random() % 8; changes > 0; --changes)
            text[random() % text.size()] = static_cast<char>(random() % 256);
        check(text, sample.kind);
    }
}

}  // namespace vitrine
