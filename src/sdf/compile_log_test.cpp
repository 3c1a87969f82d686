// SPDX-License-Identifier: MIT
// The logs are what the compilers really print; Mesa's is from 22.3.6.
#include "sdf/compile_log.hpp"

#include <gtest/gtest.h>

#include "sdf/test_support.hpp"

namespace vitrine {

namespace {

std::string described(const std::vector<CompileMessage>& messages) {
    std::string result;
    for (const CompileMessage& m : messages)
        result += std::string(m.severity == Severity::kError ? "E " : "W ") +
                  std::to_string(m.line) + ":" + std::to_string(m.column) + " " + m.message + "\n";
    return result;
}

}  // namespace

TEST(CompileLog, Mesa) {
    EXPECT_EQ(described(parseCompileLog(
                  "0:400013(47): error: `s3_undeclared' undeclared\n"
                  "3:400013(25): warning: `x' used uninitialized\n"
                  "3:400016(43): error: syntax error, unexpected '}', expecting ',' or ';'\n\n")),
              "E 400013:47 `s3_undeclared' undeclared\n"
              "W 400013:25 `x' used uninitialized\n"
              "E 400016:43 syntax error, unexpected '}', expecting ',' or ';'\n");
}

TEST(CompileLog, Nvidia) {
    EXPECT_EQ(described(parseCompileLog(
                  "0(100012) : error C1008: undefined variable \"x\"\r\n"
                  "0(7) : warning C7050: \"a\" might be used before being initialized\n")),
              "E 100012:0 undefined variable \"x\"\n"
              "W 7:0 \"a\" might be used before being initialized\n");
}

TEST(CompileLog, AngleAndGlslang) {
    EXPECT_EQ(described(parseCompileLog("test.comp\nERROR: 0:100012: 'x' : undeclared identifier\n"
                                        "WARNING: 0:3: 'y' : something\n"
                                        "ERROR: 2 compilation errors.  No code generated.\n")),
              "E 100012:0 'x' : undeclared identifier\nW 3:0 'y' : something\n");
}

TEST(CompileLog, SkipsWhatItDoesNotKnow) {
    for (const char* log :
         {"", "\n\n", "0:", "0:1", "0(1", "0:1(2: error: x", "ERROR: ", "ERROR: a:b: c",
          "99999999999:1(1): error: x", "-1:-1(1): error: x", "0:1(1): note: x", "linking failed"})
        EXPECT_TRUE(parseCompileLog(log).empty()) << log;
}

TEST(CompileLog, MapsLines) {
    const int bases[] = {lineBaseOf(0), lineBaseOf(1), lineBaseOf(7)};
    EXPECT_FALSE(mapToSnippet(99'999, bases)) << "our own shader";
    EXPECT_FALSE(mapToSnippet(100'000, bases));
    EXPECT_EQ(mapToSnippet(100'001, bases)->snippet, 0);
    EXPECT_EQ(mapToSnippet(100'001, bases)->line, 1);
    EXPECT_EQ(mapToSnippet(265'536, bases)->snippet, 1);
    EXPECT_EQ(mapToSnippet(265'536, bases)->line, 65'536);
    EXPECT_FALSE(mapToSnippet(300'001, bases));
    EXPECT_EQ(mapToSnippet(800'002, bases)->snippet, 2);
}

TEST(CompileLog, ExplainsInTheUsersTerms) {
    const Snippet first = good("float sdf(vec3 p) { return 0.0; }");
    const Snippet second = good(
        "uniform float r; // slider[0,1,2]\nfloat _f(vec3 p) {\n    return   r + p.oops; }\n"
        "float sdf(vec3 p) { return _f(p.xy); }");
    EmitOptions a = shortOptions(), b = shortOptions();
    a.prefix = "s0_";
    a.lineBase = lineBaseOf(0);
    b.prefix = "s1_";
    b.lineBase = lineBaseOf(1);
    const SnippetInProgram parts[] = {{&first, &a}, {&second, &b}};
    const auto explain = [&](const char* line) {
        const auto messages = parseCompileLog(line);
        const auto found = messages.empty() ? std::nullopt : explainMessage(messages[0], parts);
        return found ? found->text() : "nothing";
    };
    EXPECT_EQ(explain("0:200003(17): error: no field 'oops'"), "t:3:19: error: no field 'oops'")
        << "Mesa gives the column in the emitted line";
    EXPECT_EQ(explain("0:200004(34): error: no matching function for call to `s1_0_f(vec2)'; "
                      "candidates are:"),
              "t:4:28: error: no matching function for call to `_f(vec2)'; candidates are:");
    EXPECT_EQ(explain("ERROR: 0:200004: 's1_0_f' : no matching overloaded function found"),
              "t:4:28: error: '_f' : no matching overloaded function found")
        << "without a column, the quoted name is looked for";
    EXPECT_EQ(explain("ERROR: 0:200003: '' : compilation terminated"),
              "t:3:5: error: '' : compilation terminated");
    EXPECT_EQ(explain("ERROR: 0:12: 'x' : undeclared"), "nothing") << "a line of our own";
}

}  // namespace vitrine
