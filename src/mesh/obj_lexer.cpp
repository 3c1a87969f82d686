// SPDX-License-Identifier: MIT
#include "mesh/obj_lexer.hpp"

#include <charconv>
#include <limits>

namespace vitrine {
namespace {

constexpr size_t kQuotedBytes = 40;

bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}
bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// RFC 3629: no overlong forms, no surrogates, nothing beyond U+10FFFF.
bool isUtf8(std::string_view text) {
    for (size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const size_t length = lead < 0x80   ? 1
                              : lead < 0xc2 ? 0
                              : lead < 0xe0 ? 2
                              : lead < 0xf0 ? 3
                              : lead < 0xf5 ? 4
                                            : 0;
        if (length == 0 || i + length > text.size()) return false;
        for (size_t k = 1; k < length; ++k)
            if ((static_cast<unsigned char>(text[i + k]) & 0xc0) != 0x80) return false;
        if (length >= 3) {
            const auto second = static_cast<unsigned char>(text[i + 1]);
            if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
                (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f))
                return false;
        }
        i += length;
    }
    return true;
}

}  // namespace

ObjLexer::ObjLexer(std::string_view text)
    : at_(text.data()), end_(text.data() + text.size()), lineStart_(at_) {
    if (text.substr(0, 3) == "\xef\xbb\xbf") lineStart_ = at_ += 3;
}

ObjToken ObjLexer::tokenAt(const char* start) const {
    return {
        {start, static_cast<size_t>(at_ - start)}, line_, static_cast<int>(start - lineStart_) + 1};
}

void ObjLexer::skipLineEnd() {
    if (*at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n') ++at_;
    lineStart_ = ++at_;
    ++line_;
}

bool ObjLexer::skipContinuation() {
    if (*at_ != '\\' || at_ + 1 == end_ || !isLineEnd(at_[1])) return false;
    ++at_;
    skipLineEnd();
    return true;
}

void ObjLexer::skipSpace() {
    while (at_ < end_ && (isSpace(*at_) || *at_ == '\\')) {
        if (isSpace(*at_))
            ++at_;
        else if (!skipContinuation())
            return;
    }
    if (at_ < end_ && *at_ == '#')
        while (at_ < end_ && !isLineEnd(*at_)) ++at_;
}

ObjToken ObjLexer::nextStatement() {
    // What is left of the statement before, then the rest of its line and empty lines.
    if (started_)
        while (!nextWord().text.empty()) {
        }
    started_ = true;
    while (at_ < end_) {
        const ObjToken word = nextWord();
        if (!word.text.empty()) return word;
        if (at_ < end_) skipLineEnd();
    }
    return tokenAt(at_);
}

ObjToken ObjLexer::nextWord() {
    skipSpace();
    const char* start = at_;
    while (at_ < end_ && !isSpace(*at_) && !isLineEnd(*at_)) {
        if (*at_ == '\\' && at_ + 1 < end_ && isLineEnd(at_[1])) break;
        ++at_;
    }
    return tokenAt(start);
}

ObjToken ObjLexer::restOfLine() {
    skipSpace();
    const char* start = at_;
    while (at_ < end_ && !isLineEnd(*at_) && !(*at_ == '#' && at_ > start && isSpace(at_[-1])))
        ++at_;
    ObjToken token = tokenAt(start);
    while (!token.text.empty() && isSpace(token.text.back())) token.text.remove_suffix(1);
    return token;
}

std::optional<float> parseObjNumber(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const bool negative = word[0] == '-';
    if (error == std::errc::result_out_of_range) {
        // Too large or too small for a double; from_chars does not say which.
        const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos ||
                          word[negative ? 1 : 0] == '0' || word[negative ? 1 : 0] == '.';
        value = tiny ? 0.0 : negative ? -kInfinity : kInfinity;
    }
    constexpr double kMax = std::numeric_limits<float>::max();
    if (value > kMax) value = kInfinity;
    if (value < -kMax) value = -kInfinity;
    return static_cast<float>(value);
}

std::string quoteObjWord(std::string_view word) {
    std::string result = cleanObjName(word.substr(0, kQuotedBytes));
    if (word.size() > kQuotedBytes) result += "...";
    return '\'' + result + '\'';
}

std::string cleanObjName(std::string_view name) {
    const bool utf8 = isUtf8(name);
    std::string result(name);
    for (char& c : result) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f || (byte >= 0x80 && !utf8)) c = '_';
    }
    return result;
}

}  // namespace vitrine
