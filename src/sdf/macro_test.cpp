// SPDX-License-Identifier: MIT
#include <chrono>

#include <gtest/gtest.h>

#include "sdf/lexer.hpp"
#include "sdf/preprocessor.hpp"
#include "sdf/test_support.hpp"

namespace vitrine::glsl {

namespace {

std::string expanded(std::string_view source) {
    Diagnostics diagnostics;
    Problems problems(diagnostics, "");
    std::string result;
    for (const Token& token : preprocess(lex(source), problems).tokens) {
        if (!result.empty() && token.kind != TokenKind::kEnd) result += ' ';
        result += token.text;
    }
    return result + (diagnostics.list().empty() ? "" : diagnostics.text());
}

}  // namespace

TEST(Macro, ExpandsAsInC) {
    EXPECT_EQ(expanded("#define N 3\nN n NN"), "3 n NN");
    EXPECT_EQ(expanded("#define F(a, b) a*b+a\nF(x, (y,z))"), "x * ( y , z ) + x");
    EXPECT_EQ(expanded("#define F() 1\nF() F(  )"), "1 1");
    EXPECT_EQ(expanded("#define F(a) [a]\nF() F"), "[ ] F") << "without '(' it is no call";
    EXPECT_EQ(expanded("#define F (a)\nF"), "( a )") << "a space makes it an object";
    EXPECT_EQ(expanded("#define F(a) a\nF\n(\n1\n)"), "1") << "a call may span lines";
}

TEST(Macro, ExpandsArgumentsAndResultsAgain) {
    EXPECT_EQ(expanded("#define A B\n#define B 7\nA"), "7");
    EXPECT_EQ(expanded("#define F(x) <x>\nF(F(1))"), "< < 1 > >");
    EXPECT_EQ(expanded("#define G F\n#define F(x) {x}\nG(1)"), "{ 1 }")
        << "the call is finished by what follows";
    EXPECT_EQ(expanded("#define F(x) x\n#define N 2\nF(N) F(F)(3)"), "2 F ( 3 )");
}

TEST(Macro, NeverExpandsItself) {
    EXPECT_EQ(expanded("#define A A + 1\nA"), "A + 1");
    EXPECT_EQ(expanded("#define A B\n#define B A\nA B"), "A B");
    EXPECT_EQ(expanded("#define F(x) F(x)\nF(F(1))"), "F ( F ( 1 ) )");
}

TEST(Macro, CanBeTakenBackAndRepeated) {
    EXPECT_EQ(expanded("#define A 1\n#undef A\nA"), "A");
    EXPECT_EQ(expanded("#define A 1\n#define A 1\nA"), "1");
}

TEST(Macro, StandsOnTheLineOfItsName) {
    Diagnostics diagnostics;
    Problems problems(diagnostics, "");
    const Tokens tokens = preprocess(lex("#define F(a) 1 a\n\n  F(\nx) y"), problems).tokens;
    ASSERT_EQ(tokens.size(), 4u);
    EXPECT_EQ(tokens[0].place.line, 3);
    EXPECT_EQ(tokens[1].place.line, 3);
    EXPECT_EQ(tokens[1].place.column, 3);
    EXPECT_EQ(tokens[2].place.line, 4);
}

TEST(Conditional, TakesOneBranch) {
    EXPECT_EQ(expanded("#if 0\na\n#elif 1\nb\n#elif 1\nc\n#else\nd\n#endif\ne"), "b e");
    EXPECT_EQ(expanded("#ifdef X\na\n#else\nb\n#endif"), "b");
    EXPECT_EQ(expanded("#if 0\n#if 1\na\n#else\nb\n#endif\n#error no\n#include <x>\n@\n#endif\nc"),
              "c");
    EXPECT_EQ(expanded("#ifndef VITRINE\nvoid main(){}\n#endif"), "");
}

TEST(Conditional, Computes) {
    for (const char* condition :
         {"1", "2 > 1", "1 + 2 * 3 == 7", "(1 + 2) * 3 == 9", "!0 && -1 < 0", "defined(VITRINE)",
          "defined VITRINE && !defined(GL_ES)", "0x10 == 16 && 010 == 8", "~0 == -1",
          "1 << 4 == 16", "7 % 4 == 3", "__VERSION__ >= 300", "10 - 4 - 3 == 3", "N == 8",
          "1 || 0"})
        EXPECT_EQ(expanded("#define N 8\n#if " + std::string(condition) + "\nyes\n#endif"), "yes")
            << condition;
}

TEST(Conditional, ReportsWhatIsNoCondition) {
    EXPECT_EQ(problemsOf("#if 1 +\n#endif\nfloat sdf(vec3 p){return 0.;}"),
              "1:1: error: the condition is no integer expression");
    EXPECT_EQ(problemsOf("#if 1/0\n#endif\nfloat sdf(vec3 p){return 0.;}"),
              "1:1: error: the condition is no integer expression");
    EXPECT_EQ(problemsOf("#if HQ\n#endif\nfloat sdf(vec3 p){return 0.;}"),
              "1:5: warning: 'HQ' is not defined and counts as 0");
    EXPECT_EQ(problemsOf("float sdf(vec3 p){return 0.;}\n#if 1"),
              "2:1: error: no #endif closes this");
    EXPECT_EQ(problemsOf("float sdf(vec3 p){return 0.;}\n#endif"),
              "2:1: error: #endif without #if");
    EXPECT_EQ(problemsOf("float sdf(vec3 p){return 0.;}\n#if 1\n#else\n#else\n#endif"),
              "4:1: error: #else after #else");
}

TEST(MacroBomb, EndsAtTheBudget) {
    // Eight levels of eight: 8^9 tokens. Every known compiler hangs or dies on it.
    std::string bomb = "#define A0 1.0\n";
    for (int i = 1; i <= 9; ++i) {
        bomb += "#define A" + std::to_string(i);
        for (int k = 0; k < 8; ++k) bomb += " + A" + std::to_string(i - 1);
        bomb += '\n';
    }
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(problemsOf(bomb + "float sdf(vec3 p) { return A9; }"),
              "11:28: error: expanding the macro 'A9' makes more than 40000 tokens: no compiler "
              "would survive it");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST(MacroBomb, OfArgumentsAndOfNothing) {
    std::string bomb = "#define F(x) x x x x x x x x\n";
    EXPECT_NE(
        problemsOf(bomb + "float sdf(vec3 p) { return F(F(F(F(F(F(F(1.)))))));}").find("40000"),
        std::string::npos);
    bomb = "#define E\n#define A0 E E E E E E E E\n";
    for (int i = 1; i <= 9; ++i) {
        bomb += "#define A" + std::to_string(i);
        for (int k = 0; k < 8; ++k) bomb += " A" + std::to_string(i - 1);
        bomb += '\n';
    }
    EXPECT_NE(problemsOf(bomb + "A9").find("40000"), std::string::npos) << "no output, much work";
}

}  // namespace vitrine::glsl
