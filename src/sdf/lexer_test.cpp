// SPDX-License-Identifier: MIT
#include "sdf/lexer.hpp"

#include <gtest/gtest.h>

namespace vitrine::glsl {

namespace {

/// "text@line:column" of each token but the last.
std::string described(std::string_view source) {
    std::string result;
    for (const Token& token : lex(source).tokens) {
        if (token.kind == TokenKind::kEnd) break;
        if (!result.empty()) result += ' ';
        result += token.text + "@" + std::to_string(token.place.line) + ":" +
                  std::to_string(token.place.column);
    }
    return result;
}

}  // namespace

TEST(Lexer, TakesTheLongestOperator) {
    EXPECT_EQ(described("a<<=b"), "a@1:1 <<=@1:2 b@1:5");
    EXPECT_EQ(described("a+++b"), "a@1:1 ++@1:2 +@1:4 b@1:5");
    EXPECT_EQ(described("a^^b^=c"), "a@1:1 ^^@1:2 b@1:4 ^=@1:5 c@1:7");
}

TEST(Lexer, ReadsNumbersAsThePreprocessorDoes) {
    EXPECT_EQ(described("1.0e-3f+.5"), "1.0e-3f@1:1 +@1:8 .5@1:9");
    EXPECT_EQ(described("0x1E-1"), "0x1E@1:1 -@1:5 1@1:6") << "no exponent in hexadecimals";
    EXPECT_EQ(described("a.x1.y"), "a@1:1 .@1:2 x1@1:3 .@1:5 y@1:6");
}

TEST(Lexer, CountsLinesThroughCommentsAndJoinedLines) {
    EXPECT_EQ(described("a // b\nc"), "a@1:1 c@2:1");
    EXPECT_EQ(described("a /* b\n\n */ c"), "a@1:1 c@3:5");
    EXPECT_EQ(described("ab\\\ncd\ne"), "abcd@1:1 e@3:1");
    EXPECT_EQ(described("a\\\r\nb\r\nc"), "ab@1:1 c@3:1");
    EXPECT_EQ(described("// a \\\n b\nc"), "c@3:1") << "a joined line is still comment";
}

TEST(Lexer, KnowsWhatBeginsALine) {
    const Tokens tokens = lex("#a \\\n #b\n /* */ #c").tokens;
    ASSERT_EQ(tokens.size(), 7u);
    EXPECT_TRUE(tokens[0].startsLine);
    EXPECT_FALSE(tokens[2].startsLine) << "joined with the line above";
    EXPECT_TRUE(tokens[4].startsLine);
}

TEST(Lexer, KeepsCommentsWithTheirPlaces) {
    const auto comments = lex("a; // one\n/*two*/").comments;
    ASSERT_EQ(comments.size(), 2u);
    EXPECT_EQ(comments[0].text, " one");
    EXPECT_EQ(comments[0].place.column, 6);
    EXPECT_FALSE(comments[0].startsLine);
    EXPECT_EQ(comments[1].text, "two");
    EXPECT_EQ(comments[1].place.line, 2);
    EXPECT_TRUE(comments[1].startsLine);
}

TEST(Lexer, PlacesWhatIsOpenOrForeign) {
    EXPECT_EQ(lex("a\n  /* b").openComment.line, 2);
    EXPECT_EQ(lex("a /* b */").openComment.line, 0);
    const Tokens tokens = lex("a \xE2\x88\x92 b").tokens;
    EXPECT_EQ(tokens[1].kind, TokenKind::kOther);
    EXPECT_EQ(tokens[1].text, "\xE2\x88\x92");
    EXPECT_EQ(tokens[2].place.column, 7) << "columns are bytes";
}

TEST(Lexer, PrintableHidesWhatATerminalMustNotSee) {
    EXPECT_EQ(printable("Gr\xC3\xBC\xC3\x9F"
                        "e"),
              "Gr\xC3\xBC\xC3\x9F"
              "e");
    EXPECT_EQ(printable("a\x1B[2J\x80z"), "a?[2J?z");
    EXPECT_EQ(printable("\xC0\xAF \xED\xA0\x80"), "?? ???") << "overlong form and surrogate";
    EXPECT_EQ(printable("abcdef", 3), "abc...");
}

}  // namespace vitrine::glsl
