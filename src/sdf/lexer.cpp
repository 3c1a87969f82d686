// SPDX-License-Identifier: MIT
#include "sdf/lexer.hpp"

#include <array>

namespace vitrine::glsl {

namespace {

bool isDigit(int c) {
    return c >= '0' && c <= '9';
}
bool startsWord(int c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isWordPart(int c) {
    return startsWord(c) || isDigit(c);
}
bool isSpace(int c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// Longest first, so that the first fit is the longest one.
constexpr std::array<std::string_view, 22> kLongOperators = {
    "<<=", ">>=", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&",
    "||",  "^^",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "##"};
constexpr std::string_view kShortOperators = "()[]{}.,;:?+-*/%<>=!~&|^#";

/// Reads characters and keeps the place; a backslash at the end of a line joins it with the next.
class Cursor {
  public:
    explicit Cursor(std::string_view source) : source_(source) { join(); }

    /// The character `ahead` of the current one, -1 behind the end.
    [[nodiscard]] int peek(int ahead = 0) const {
        Cursor copy = *this;
        for (; ahead > 0; --ahead) copy.next();
        return copy.current();
    }
    [[nodiscard]] int current() const {
        return at_ < source_.size() ? static_cast<unsigned char>(source_[at_]) : -1;
    }
    [[nodiscard]] Place place() const { return place_; }

    char next() {
        const char c = source_[at_];
        step();
        join();
        return c;
    }

  private:
    void step() {
        if (at_ >= source_.size()) return;
        if (source_[at_] == '\n') {
            ++place_.line;
            place_.column = 1;
        } else {
            ++place_.column;
        }
        ++at_;
    }
    void join() {
        while (current() == '\\') {
            size_t end = at_ + 1;
            if (end < source_.size() && source_[end] == '\r') ++end;
            if (end >= source_.size() || source_[end] != '\n') return;
            while (at_ <= end) step();
        }
    }

    std::string_view source_;
    size_t at_ = 0;
    Place place_;
};

class Lexer {
  public:
    explicit Lexer(std::string_view source) : cursor_(source) {}

    LexedText run() {
        while (cursor_.current() >= 0) {
            const int c = cursor_.current();
            if (c == '\n') {
                cursor_.next();
                startsLine_ = true;
                space_ = true;
            } else if (isSpace(c)) {
                cursor_.next();
                space_ = true;
            } else if (c == '/' && cursor_.peek(1) == '/') {
                lineComment();
            } else if (c == '/' && cursor_.peek(1) == '*') {
                blockComment();
            } else {
                token(c);
            }
        }
        begin(TokenKind::kEnd);
        return std::move(result_);
    }

  private:
    Token& begin(TokenKind kind) {
        result_.tokens.push_back({kind, {}, cursor_.place(), space_, startsLine_});
        space_ = startsLine_ = false;
        return result_.tokens.back();
    }

    void token(int c) {
        if (startsWord(c)) {
            take(begin(TokenKind::kWord), isWordPart);
        } else if (isDigit(c) || (c == '.' && isDigit(cursor_.peek(1)))) {
            number(begin(TokenKind::kNumber));
        } else if (c >= 0x80) {
            take(begin(TokenKind::kOther), [](int d) { return d >= 0x80; });
        } else if (kShortOperators.find(static_cast<char>(c)) != std::string_view::npos) {
            operation(begin(TokenKind::kOperator));
        } else {
            Token& other = begin(TokenKind::kOther);
            other.text = cursor_.next();
        }
    }

    template <class Predicate>
    void take(Token& token, Predicate belongs) {
        while (cursor_.current() >= 0 && belongs(cursor_.current())) token.text += cursor_.next();
    }

    void number(Token& token) {
        const bool hex = cursor_.current() == '0' && (cursor_.peek(1) | 0x20) == 'x';
        for (int c = cursor_.current(); isWordPart(c) || c == '.'; c = cursor_.current()) {
            token.text += cursor_.next();
            const int sign = cursor_.current();
            if (!hex && (c | 0x20) == 'e' && (sign == '+' || sign == '-'))
                token.text += cursor_.next();
        }
    }

    void operation(Token& token) {
        for (const std::string_view candidate : kLongOperators) {
            size_t length = 0;
            while (length < candidate.size() &&
                   cursor_.peek(static_cast<int>(length)) == candidate[length])
                ++length;
            if (length < candidate.size()) continue;
            for (; length > 0; --length) token.text += cursor_.next();
            return;
        }
        token.text += cursor_.next();
    }

    Comment& beginComment() {
        cursor_.next();
        cursor_.next();
        result_.comments.push_back({{}, cursor_.place(), startsLine_});
        space_ = true;
        return result_.comments.back();
    }

    void lineComment() {
        Comment& comment = beginComment();
        while (cursor_.current() >= 0 && cursor_.current() != '\n') comment.text += cursor_.next();
    }

    void blockComment() {
        const Place opened = cursor_.place();
        Comment& comment = beginComment();
        while (cursor_.current() >= 0) {
            if (cursor_.current() == '*' && cursor_.peek(1) == '/') {
                cursor_.next();
                cursor_.next();
                return;
            }
            comment.text += cursor_.next();
        }
        result_.openComment = opened;
    }

    Cursor cursor_;
    LexedText result_;
    bool space_ = false;
    bool startsLine_ = true;
};

/// Length of the UTF-8 sequence at the start of `text`, 0 if there is none.
size_t utf8Length(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const size_t length = byte(0) < 0x80                       ? 1
                          : byte(0) >= 0xC2 && byte(0) < 0xE0  ? 2
                          : byte(0) >= 0xE0 && byte(0) < 0xF0  ? 3
                          : byte(0) >= 0xF0 && byte(0) <= 0xF4 ? 4
                                                               : 0;
    if (length > text.size()) return 0;
    for (size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    // Overlong forms, surrogates and what lies beyond the last code point.
    if (length == 3 && byte(0) == 0xE0 && byte(1) < 0xA0) return 0;
    if (length == 3 && byte(0) == 0xED && byte(1) >= 0xA0) return 0;
    if (length == 4 && byte(0) == 0xF0 && byte(1) < 0x90) return 0;
    if (length == 4 && byte(0) == 0xF4 && byte(1) >= 0x90) return 0;
    return length;
}

}  // namespace

LexedText lex(std::string_view source) {
    return Lexer(source).run();
}

std::string printable(std::string_view text, size_t maxBytes) {
    std::string result;
    while (!text.empty()) {
        const size_t length = utf8Length(text);
        const bool control = length == 1 && (text[0] < ' ' || text[0] == 0x7F);
        if (length == 0 || control)
            result += '?';
        else
            result += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
        if (result.size() >= maxBytes && !text.empty()) return result + "...";
    }
    return result;
}

}  // namespace vitrine::glsl
