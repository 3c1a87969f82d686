// SPDX-License-Identifier: MIT
#include "sdf/snippet.hpp"

#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>

#include "sdf/test_support.hpp"

namespace vitrine {

namespace {

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

const std::string kEntry = "float sdf(vec3 p) { return 0.0; }\n";

}  // namespace

TEST(Snippet, KindOfFile) {
    EXPECT_EQ(snippetKindOf("a/b.sdf.glsl"), SnippetKind::kField);
    EXPECT_EQ(snippetKindOf("b.mat.glsl"), SnippetKind::kMaterial);
    EXPECT_EQ(snippetKindOf("b.screen.glsl"), SnippetKind::kScreen);
    EXPECT_EQ(snippetKindOf("b.glsl"), std::nullopt);
}

TEST(Snippet, EntryByRank) {
    const std::string de = "float DE(vec3 p) { return 3.0; }",
                      map = "vec2 map(vec3 p) { return vec2(0.0); }";
    EXPECT_EQ(good(de).entry, "DE");
    EXPECT_EQ(good(de + map).entry, "map");
    EXPECT_TRUE(good(de + map).entryReturnsPart);
    EXPECT_EQ(good(de + map + kEntry).entry, "sdf");
    EXPECT_FALSE(good(de + map + kEntry).entryReturnsPart);
    EXPECT_EQ(good("float sdf(vec2 p) { return 0.0; }" + de).entry, "DE")
        << "a helper in two dimensions";
    EXPECT_EQ(good("float sdf(in vec3) { return 0.0; }").entry, "sdf");
}

TEST(Snippet, MistakesHaveAPlace) {
    std::string many;
    for (int i = 0; i < 301; ++i) many += "void f" + std::to_string(i) + "(){}";
    const std::pair<std::string, const char*> table[] = {
        {"",
         "1:1: error: no entry function: define float sdf(vec3 p), or vec2 sdf(vec3 p) for "
         "(distance, part) (accepted names: sdf, map, DE)"},
        {"\n float sdv(vec3 p) { return 0.0; }",
         "1:1: error: no entry function: define float sdf(vec3 p), or vec2 sdf(vec3 p) for "
         "(distance, part) (accepted names: sdf, map, DE); did you mean 'sdv' on line 2 to be "
         "'sdf'?"},
        {"float map(vec2 p) { return 0.0; }",
         "1:7: error: 'map' must be float map(vec3 p), or vec2 map(vec3 p) for (distance, part)"},
        {"float map(inout vec3 p) { return 0.0; }",
         "1:7: error: 'map' must be float map(vec3 p), or vec2 map(vec3 p) for (distance, part)"},
        {"float sdf(vec3 p);",
         "1:7: error: 'sdf' must be float sdf(vec3 p), or vec2 sdf(vec3 p) for (distance, part)"},
        {kEntry + "void mainImage(out vec4 c, in vec2 p) {}",
         "2:6: error: 'mainImage' in a .sdf.glsl file: a distance field draws no picture: remove "
         "it, "
         "or put it inside of #ifndef VITRINE"},
        {"#version 300 es\n" + kEntry,
         "1:1: error: #version is not for snippets: the renderer chooses the version; for other "
         "programs, put it inside of #ifndef VITRINE"},
        {" # include \"lib.glsl\"\n" + kEntry,
         "1:2: error: #include is not for snippets: a snippet is one file: paste the text here; "
         "shaders/lib/sdf is there without it"},
        {"#extension all : enable\n#line 7\n#pragma x\n#error too old\n#foo\n#defin A\n" + kEntry,
         "1:1: error: #extension is not for snippets: a snippet has to run everywhere, without "
         "extensions\n"
         "2:1: error: #line is not for snippets: the renderer counts the lines\n"
         "3:1: error: #pragma is not for snippets: the renderer sets them\n"
         "4:1: error: #error too old\n"
         "5:1: error: unknown directive #foo\n"
         "6:1: error: unknown directive #defin (did you mean 'define'?)"},
        {"#define A(x) a##x\n" + kEntry, "1:15: error: GLSL has no '##' in macros"},
        {"#define F(1) a\n" + kEntry,
         "1:11: error: the parameters of a macro are names, as in #define F(a, b)"},
        {"#define A 1\n#define A 2\n" + kEntry,
         "2:9: error: macro 'A' is already defined on line 1; #undef it first"},
        {"#define a__b 1\n#define GL_ES 1\n" + kEntry,
         "1:9: error: the name 'a__b' is reserved\n2:9: error: the name 'GL_ES' is reserved"},
        {"#define F(a, b) a\n" + kEntry + "float g() { return F(1.0); }",
         "3:20: error: macro 'F' takes 2 arguments, not 1"},
        {"float a__b = 1.0;\n" + kEntry,
         "1:7: error: 'a__b': two underscores in a row are reserved in GLSL"},
        {"float gl_x = 1.0;\n" + kEntry,
         "1:7: error: 'gl_x': names that begin with gl_ are reserved"},
        {"float sdf(vec3 p) { return gl_FragCoord.x; }",
         "1:28: error: 'gl_FragCoord' cannot be used: a snippet is called for rays, outside of any "
         "shader stage"},
        {"float sdf(vec3 p) { discard; }",
         "1:21: error: 'discard' cannot be used: a ray asks for a value, there is no pixel to "
         "discard"},
        {"float sdf(vec3 p) { return texture(iChannel0, p.xy).x; }",
         "1:28: error: 'texture' cannot be used: snippets have no textures\n"
         "1:36: error: 'iChannel0' cannot be used: snippets have no textures"},
        {"uniform sampler2D s;\n" + kEntry, "1:9: error: snippets have no textures"},
        {"uniform mat3 m;\n" + kEntry,
         "1:9: error: a uniform is a float, int, bool, vec2, vec3 or vec4, not a 'mat3'"},
        {"uniform float a[3];\n" + kEntry, "1:16: error: a uniform cannot be an array here"},
        {"uniform float a = 1.0;\n" + kEntry,
         "1:17: error: the default of a uniform stands behind it: uniform float a; // slider[min, "
         "default, max]"},
        {"uniform;\n" + kEntry,
         "1:1: error: expected a uniform such as: uniform float r; // slider[0.0, 0.5, 1.0]"},
        {"uniform vec3 time;\n" + kEntry, "1:9: error: 'time' is built in as a float"},
        {"uniform bool a;\nfloat a;\n" + kEntry, "2:7: error: 'a' is already declared on line 1"},
        {"uniform bool sdf;\n" + kEntry, "2:7: error: 'sdf' is already declared on line 1"},
        {"layout(location = 0) out vec4 c;\n" + kEntry,
         "1:1: error: 'layout' belongs to a whole shader; a snippet has functions, constants and "
         "uniforms of its own"},
        {"float x = time;\n" + kEntry,
         "1:11: error: 'time' changes, and the initial value of a global variable must be "
         "constant"},
        {"x = 3;\n}\n" + kEntry, "2:1: error: nothing is open that this '}' could close"},
        {"x = 3;\n" + kEntry,
         "1:1: error: expected a function, a constant or a uniform, found 'x'"},
        {kEntry + "float f() { if (true) {", "2:11: error: nothing closes this '{'"},
        {"float f() { a(1]; }\n" + kEntry, "1:16: error: ']' cannot close the '(' of line 1"},
        {"/* never\n" + kEntry, "1:1: error: nothing closes this comment"},
        {"float sdf(vec3 p) { return 0.0 }", "1:28: error: a ';' is missing behind this"},
        {"float sdf(vec3 p) { float a = 1.0 return a; }",
         "1:35: error: 'return' inside of an expression; is a ';' missing?"},
        {"float sdf(vec3 p) { float a b; return a; }",
         "1:29: error: expected ',' or ';', found 'b'"},
        {"float sdf(vec3 p) { for (int i = 0; i < 3) {} return 0.0; }",
         "1:21: error: a loop is written: for (start; condition; step)"},
        {"float sdf(vec3 p) { do { } return 0.0; }",
         "1:28: error: expected 'while' of the 'do', found 'return'"},
        {"float sdf(vec3 p) { else return 0.0; }", "1:21: error: 'else' without 'if'"},
        {"float sdf(vec3 p) { return (1.0; 2.0); }", "1:32: error: a ';' inside of an expression"},
        {"float sdf(vec3 p) { float return = 1.0; }",
         "1:27: error: 'return' inside of an expression; is a ';' missing?"},
        {"float f(for x) { return 0.0; }\n" + kEntry, "1:9: error: expected a type, found 'for'"},
        {"float vec3() { return 0.0; }\n" + kEntry,
         "1:7: error: 'vec3' is a word of GLSL and cannot be a name"},
        {"float x = '1';\n" + kEntry, "1:11: error: GLSL has no '''\n1:13: error: GLSL has no '''"},
        {std::string("float\0x;", 8) + kEntry, "1:6: error: a NUL byte: this is not a text file"},
        {"float x = 1 \xE2\x88\x92 2;\n" + kEntry,
         "1:13: error: '\xE2\x88\x92' is not ASCII, which GLSL allows only in comments"},
        {"float a[1025];\n" + kEntry,
         "1:9: error: an array of 1025; the length lies between 1 and 1024"},
        {"const int N = 1 << 28;\nfloat a[N];\n" + kEntry,
         "2:9: error: an array of 268435456; the length lies between 1 and 1024"},
        {"const int N = int(exp2(28.0));\nfloat a[N];\n" + kEntry,
         "2:9: error: the length of an array must be a whole number or made of const ints"},
        {"struct S { float a[1024]; }; S b[1024];\n" + kEntry,
         "1:32: error: more than 16384 numbers in arrays: no compiler would survive it"},
        {"float a[2][3];\n" + kEntry, "1:11: error: arrays of arrays do not exist in WebGL2"},
        {"float f(float x) { return f(x); }\n" + kEntry,
         "1:27: error: 'f' calls itself (f -> f), and GLSL has no recursion"},
        {"float g(float x);\nfloat f(float x) { return g(x); }\nfloat g(float x) { return f(x); "
         "}\n" +
             kEntry,
         "2:27: error: 'g' calls itself (g -> f -> g), and GLSL has no recursion"},
        {"float g(float x);\nfloat sdf(vec3 p) { return g(1.0); }",
         "2:28: error: 'g' is declared, but its body is missing"},
        {"float sdf(vec3 p) " + repeated("{", 70) + repeated("}", 70),
         "1:83: error: more than 64 brackets inside of each other"},
        {"float sdf(vec3 p) { " + repeated("if (true) ", 70) + "return 0.0; }",
         "1:661: error: more than 64 statements inside of each other"},
        {repeated("x ", 40'000), "1:1: error: 80000 bytes; a snippet has at most 65536"},
        {repeated(";", 30'000), "1:20001: error: more than 20000 words and signs"},
        {"float " + std::string(201, 'x') + ";\n" + kEntry,
         "1:7: error: a name of 201 characters; at most 200 are allowed"},
        {"void f(){}\nvoid f() {}" + kEntry, "2:6: error: 'f' already has a body, on line 1"},
        {many + kEntry, "1:1: error: 302 functions; at most 300 are compiled in bearable time"},
    };
    for (const auto& [source, expected] : table)
        EXPECT_EQ(problemsOf(source), expected) << source.substr(0, 200);
}

TEST(Snippet, OtherKindsHaveTheirOwnEntry) {
    EXPECT_EQ(problemsOf("float sdf(vec3 p) { return 0.0; }", SnippetKind::kMaterial),
              "1:1: error: no entry function: define void material(inout Surface s)");
    EXPECT_EQ(problemsOf("void material(Surface s) {}", SnippetKind::kMaterial),
              "1:6: error: 'material' must be void material(inout Surface s)");
    EXPECT_EQ(
        problemsOf("void mainImage(out vec4 c, vec2 p) {}\nvoid main() {}", SnippetKind::kScreen),
        "2:6: error: 'main' in a .screen.glsl file: the renderer has its own: remove it, or put "
        "it inside of #ifndef VITRINE");
    EXPECT_EQ(problemsOf("// bounds[0,0,0,1,1,1]\nvoid material(inout Surface s) {}",
                         SnippetKind::kMaterial),
              "1:4: warning: bounds means something only in a field");
}

TEST(Snippet, UsesTimeOnlyIfItReadsTheBuiltIn) {
    const auto uses = [](const std::string& text) { return good(text).usesTime; };
    EXPECT_TRUE(uses("float sdf(vec3 p) { return iTime; }"));
    EXPECT_TRUE(uses("uniform float u_time; float sdf(vec3 p) { return u_time; }"));
    EXPECT_FALSE(uses("uniform float time; // slider[0,1,2]\nfloat sdf(vec3 p) { return time; }"));
    EXPECT_FALSE(uses("float sdf(vec3 time) { return time.x; }"));
    EXPECT_FALSE(uses("float sdf(vec3 p) { return p.time; }"));
    EXPECT_FALSE(uses("float time = 1.0; float sdf(vec3 p) { return time; }"));
    EXPECT_FALSE(uses(kEntry));
}

TEST(Snippet, RecursionIsNotSeenInOverloads) {
    EXPECT_EQ(problemsOf("float f(vec2 x) { return x.x; }\nfloat f(vec3 x) { return f(x.xy); }\n" +
                         kEntry),
              "");
    EXPECT_EQ(problemsOf("float f(float f) { return f; }\n" + kEntry), "");
}

TEST(Snippet, ReportsSeveralErrorsButNotThousands) {
    const std::string all = problemsOf(repeated("#pragma\n", 100));
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 30);
    EXPECT_NE(all.find("30:1: error: more errors follow, not shown"), std::string::npos);
}

TEST(Snippet, LongElseIfChainsAreFine) {
    EXPECT_EQ(problemsOf("float sdf(vec3 p) { " +
                         repeated("if (p.x > 0.0) return 1.0; else ", 500) + "return 0.0; }"),
              "");
}

TEST(Snippet, ByteOrderMarkIsSkipped) {
    EXPECT_EQ(problemsOf("\xEF\xBB\xBF" + kEntry), "");
}

TEST(Snippet, TheWorstInputIsQuick) {
    const auto start = std::chrono::steady_clock::now();
    problemsOf(repeated("/**/", 16'000));
    problemsOf(repeated("//a[\n", 13'000));
    problemsOf(repeated("#if 0\n#endif\n", 5'000));
    problemsOf(repeated("#define A\n", 6'000));
    problemsOf(repeated("f(float a);", 3'000));
    problemsOf("float f(float a){" + repeated("f(", 60) + repeated("a+", 9'000) + "a" +
               repeated(")", 60) + ";}");
    problemsOf(repeated("void f(int a){f(a);}", 1'900));
    problemsOf("#define F(x) x\n" + repeated("F(", 9'000));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace vitrine
