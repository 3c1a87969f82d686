// SPDX-License-Identifier: MIT
// The smallest parts of a GLSL text, with their places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vitrine::glsl {

/// Counted from 1, columns in bytes.
struct Place {
    int line = 1;
    int column = 1;
};

enum class TokenKind {
    kWord,      // names and keywords
    kNumber,    // as the C preprocessor sees numbers: "1.0e-3f", but also the malformed "1.x"
    kOperator,  // the longest that fits: "<<=", "(", "#"
    kOther,     // a character that GLSL has no use for; harmless where a # line skips it
    kEnd,
};

struct Token {
    TokenKind kind = TokenKind::kEnd;
    std::string text;
    Place place;
    bool spaceBefore = false;
    /// First of its line, where lines joined by a backslash are one.
    bool startsLine = false;
    /// A macro's name that must not be expanded any more (it came out of that macro).
    bool painted = false;

    [[nodiscard]] bool is(std::string_view s) const {
        return text == s && (kind == TokenKind::kWord || kind == TokenKind::kOperator);
    }
    [[nodiscard]] bool isWord() const { return kind == TokenKind::kWord; }
};

using Tokens = std::vector<Token>;

struct Comment {
    /// Without its slashes and stars.
    std::string text;
    /// Of the first character of `text`.
    Place place;
    /// Nothing but white space stands before it on its line.
    bool startsLine = false;
};

/// `text` for a message: control characters and what is not UTF-8 become '?', and long text is cut.
std::string printable(std::string_view text, size_t maxBytes = 80);

}  // namespace vitrine::glsl
