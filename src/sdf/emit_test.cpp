// SPDX-License-Identifier: MIT
#include "sdf/emit.hpp"

#include <gtest/gtest.h>

#include "sdf/test_support.hpp"

namespace vitrine {

TEST(Emit, Golden) {
    EXPECT_EQ(emitted(R"(// bounds[-1,-1,-1,1,1,1]
uniform float r; // slider[0, 1, 2] Radius
uniform vec3 c;  // color[1, 0, 0]

#define SQ(x) ((x)*(x))
struct Hit { float d; float r; };
const int N = 4;

Hit shape(vec3 p, inout float acc) {
    Hit h = Hit(length(p) - r, c.x);  // a comment
    for (int i = 0; i < N; i++)
        acc += SQ(h.r) * sin(iTime);
    return h;
}




float sdf(vec3 p) { float a; return shape(p, a).d + opSmoothUnion(a, r, 0.1); }
)"),
              R"(#line 1006
struct X_Hit { float d; float r; };
const int X_N = 4;

X_Hit X_shape(vec3 X_p, inout float X_acc) {
X_Hit X_h = X_Hit(length(X_p) - P0, P1.xyz.x);
for (int X_i = 0; G() && (X_i < X_N); X_i++)
X_acc += (( X_h.r )*( X_h.r )) * sin(T);
return X_h;
}
#line 1019
float X_sdf(vec3 X_p) { float X_a; return X_shape(X_p, X_a).d + opSmoothUnion(X_a, P0, 0.1); }
)");
}

TEST(Emit, IsTheSameEveryTimeAndDependsOnThePrefix) {
    const Snippet snippet =
        good("float rot(float a) { return a; } float sdf(vec3 p) { return rot(p.x); }");
    EmitOptions options = shortOptions();
    const std::string first = emitSnippet(snippet, options);
    EXPECT_EQ(first, emitSnippet(snippet, options));
    options.prefix = "Y_";
    const std::string second = emitSnippet(snippet, options);
    EXPECT_NE(first.find("float X_rot("), std::string::npos);
    EXPECT_NE(second.find("float Y_rot("), std::string::npos);
    for (const std::string& text : {first, second})
        EXPECT_EQ(text.find(" rot"), std::string::npos) << "two snippets may both have a rot";
}

TEST(Emit, Loops) {
    EXPECT_EQ(emittedBody("for (int i=0; i<3; i++) r;"),
              "for (int X_i=0; G() && (X_i<3); X_i++) P0;");
    EXPECT_EQ(emittedBody("for(;;);"), "for(;G(););");
    EXPECT_EQ(emittedBody("for (p.x = 0., p.y = 1.; ; ) {}"),
              "for (X_p.x = 0., X_p.y = 1.; G() ; ) {}");
    EXPECT_EQ(emittedBody("while (p.x < 1. || p.y > 2.) p *= 2.;"),
              "while (G() && (X_p.x < 1. || X_p.y > 2.)) X_p *= 2.;");
    EXPECT_EQ(emittedBody("do p *= 2.; while(true);"), "do X_p *= 2.; while(G() && (true));");
    EXPECT_EQ(emittedBody("do while(true) {} while(false);"),
              "do while(G() && (true)) {} while(G() && (false));");
    EXPECT_EQ(emittedBody("while (bool b = p.x < 1.) { b; } r;"),
              "while (bool X_b = G() && (X_p.x < 1.)) { X_b; } P0;");
    EXPECT_EQ(emittedBody("for (int i; bool b = true; i++) b;"),
              "for (int X_i; bool X_b = G() && (true); X_i++) X_b;");
    EXPECT_EQ(
        emittedBody("if (true) for (;;) while (true) break; else do ; while (true);"),
        "if (true) for (;G();) while (G() && (true)) break; else do ; while (G() && (true));");
    EXPECT_EQ(emittedBody("for (int i = 0;\ni < 3;\ni++)\n;"),
              "for (int X_i = 0;\nG() && (X_i < 3);\nX_i++)\n;");
}

TEST(Emit, NoLoopHidesInAMacro) {
    EXPECT_EQ(
        emittedBody(
            "\n#define LOOP(c) while (c)\n#define EVER ;;\nLOOP(true) for (EVER) LOOP(r > 1.) ;"),
        "\n\n\nwhile ( G() && (true) ) for ( ;G(); ) while ( G() && (P0 > 1.) ) ;");
}

TEST(Emit, SignsOfMacrosDoNotStick) {
    EXPECT_EQ(emittedBody("\n#define N -1.\n#define M -\n#define F(a) -a-\n-N M-1. F(-p)-F(p);"),
              "#line 1007\n- -1. - -1. - -X_p - - - X_p - ;");
}

TEST(Emit, ShadowedNames) {
    // `r` is a parameter of the snippet.
    const std::pair<const char*, const char*> table[] = {
        {"r; p.r; p.xr;", "P0; X_p.r; X_p.xr;"},
        {"float r; r;", "float X_r; X_r;"},
        {"float r = r; r;", "float X_r = P0; X_r;"},
        {"float a = r, r = a, b = r;", "float X_a = P0, X_r = X_a, X_b = X_r;"},
        {"{ float r; r; } r;", "{ float X_r; X_r; } P0;"},
        {"for (int r = 0; r < 3; r++) r; r;",
         "for (int X_r = 0; G() && (X_r < 3); X_r++) X_r; P0;"},
        {"for (;;) { float r; } r;", "for (;G();) { float X_r; } P0;"},
        {"if (r > 0.) float r; r;", "if (P0 > 0.) float X_r; P0;"},
        {"if (true) float r; else r; r;", "if (true) float X_r; else P0; P0;"},
        {"while (true) float r; r;", "while (G() && (true)) float X_r; P0;"},
        {"do { float r; } while (r > 0.);", "do { float X_r; } while (G() && (P0 > 0.));"},
        {"float[2] r; r[0];", "float[2] X_r; X_r[0];"},
        {"const highp vec3 r = p; r.r;", "const highp vec3 X_r = X_p; X_r.r;"},
        {"struct S { float r; }; S s; s.r = r;", "struct X_S { float r; }; X_S X_s; X_s.r = P0;"},
        {"{ struct r { float x; }; r q; } r;", "{ struct X_r { float x; }; X_r X_q; } P0;"},
        {"switch (int(r)) { case 0: float r; r; default: r; } r;",
         "switch (int(P0)) { case 0: float X_r; X_r; default: X_r; } P0;"},
        {"p[int(r)]; abs(r)[int(r)].r;", "X_p[int(P0)]; abs(P0)[int(P0)].r;"},
        {"float time; time; { iTime; }", "float X_time; X_time; { T; }"},
        {"int sdf = 3; sdf;", "int X_sdf = 3; X_sdf;"},
        {"r > 0. ? r : r;", "P0 > 0. ? P0 : P0;"},
    };
    for (const auto& [body, expected] : table) EXPECT_EQ(emittedBody(body), expected) << body;
}

TEST(Emit, ParametersOfFunctionsShadowToo) {
    EXPECT_EQ(
        emitted("uniform float r; // slider[0,1,2]\n"
                "float f(float r, float g) { return r; } float g(float) { return r; }\n"
                "float h(float f) { return f + g(f); }\n"
                "float sdf(vec3 p) { return f(r, 1.); }"),
        "#line 1002\n"
        "float X_f(float X_r, float X_g) { return X_r; } float X_g(float X_0p0) { return P0; }\n"
        "float X_h(float X_f) { return X_f + X_g(X_f); }\n"
        "float X_sdf(vec3 X_p) { return X_f(P0, 1.); }\n");
}

TEST(Emit, OverloadsOfOtherPeoplesFunctions) {
    EXPECT_EQ(emitted("float f(vec3 v) { return max(v.x, v.y); }\n"
                      "float max(vec3 v) { return max(v.x, max(v.y, v.z)); }\n"
                      "float sdf(vec3 p) { return max(p) + max(p.x, f(p)); }")
                  .substr(10),
              "\nfloat X_f(vec3 X_v) { return max(X_v.x, X_v.y); }\n"
              "float X_max(vec3 X_v) { return max(X_v.x, max(X_v.y, X_v.z)); }\n"
              "float X_sdf(vec3 X_p) { return X_max(X_p) + max(X_p.x, X_f(X_p)); }\n");
}

TEST(Emit, NamesThatBeginWithAnUnderscore) {
    EXPECT_EQ(emittedName("s3_", "sdf"), "s3_sdf");
    EXPECT_EQ(emittedName("s3_", "_a"), "s3_0_a");
}

TEST(Emit, BuiltInsOfScreens) {
    EXPECT_EQ(emitted("uniform vec2 u_resolution;\nvoid mainImage(out vec4 c, in vec2 p) {\n"
                      "c = vec4(p / u_resolution, iResolution.z, iFrame); }",
                      SnippetKind::kScreen),
              "#line 1002\nvoid X_mainImage(out vec4 X_c, in vec2 X_p) {\n"
              "X_c = vec4(X_p / R.xy, R.z, frame); }\n");
    EXPECT_EQ(problemsOf("float sdf(vec3 p) { return iResolution.x; }"),
              "1:28: error: 'iResolution' is not declared")
        << "a field has none";
}

TEST(Emit, ColumnsLeadBack) {
    const Snippet snippet = good(
        "uniform float radius; // slider[0,1,2]\n"
        "float sdf(vec3 p)   { return   radius + p.undeclared; }");
    const std::string text = emitSnippet(snippet, shortOptions());
    EXPECT_EQ(text, "#line 1002\nfloat X_sdf(vec3 X_p) { return P0 + X_p.undeclared; }\n");
    EXPECT_EQ(originalColumn(snippet, shortOptions(), 2, 1), 1);
    EXPECT_EQ(originalColumn(snippet, shortOptions(), 2, 32), 32) << "radius";
    EXPECT_EQ(originalColumn(snippet, shortOptions(), 2, 41), 43) << "undeclared";
    EXPECT_EQ(originalColumn(snippet, shortOptions(), 2, 44), 43) << "within it";
    EXPECT_EQ(originalColumn(snippet, shortOptions(), 1, 1), 0) << "nothing was emitted there";
}

}  // namespace vitrine
