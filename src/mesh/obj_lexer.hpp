// SPDX-License-Identifier: MIT
// The words of an OBJ file, with their places.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

struct ObjToken {
    std::string_view text;  ///< empty at the end of a statement
    int line = 0, column = 0;
};

/// Splits text into statements (lines, joined by a backslash at the end) and those into words.
/// Lines end with "\n", "\r\n" or "\r"; "#" at the start of a word begins a comment.
class ObjLexer {
  public:
    explicit ObjLexer(std::string_view text);

    /// The first word of the next statement that has any; empty at the end of the file. Skips what
    /// is left of the statement before.
    ObjToken nextStatement();
    /// The next word of this statement.
    ObjToken nextWord();
    /// What is left of this statement's line, without spaces around it and a comment after it.
    ObjToken restOfLine();

  private:
    void skipSpace();
    bool skipContinuation();
    void skipLineEnd();
    [[nodiscard]] ObjToken tokenAt(const char* start) const;

    const char* at_;
    const char* end_;
    const char* lineStart_;
    int line_ = 1;
    bool started_ = false;
};

/// All of `word` as a number; independent of the locale. Beyond the range of floats it is infinite
/// or zero, and "nan" and "inf" are numbers too.
std::optional<float> parseObjNumber(std::string_view word);

/// For messages: at most 40 bytes, control characters and broken UTF-8 replaced.
std::string quoteObjWord(std::string_view word);

/// `name` with control characters replaced by "_", and all that is not ASCII if it is no UTF-8.
std::string cleanObjName(std::string_view name);

}  // namespace vitrine
