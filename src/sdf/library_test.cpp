// SPDX-License-Identifier: MIT
// How snippets use the library; that its functions keep what their comments promise is tested in
// library_claims_test.cpp.
#include "sdf/library.hpp"

#include <set>

#include <gtest/gtest.h>

#include "base/text.hpp"
#include "sdf/test_support.hpp"

namespace vitrine {

namespace {

/// The functions that a text for these names defines, in order.
std::string defined(const std::set<std::string>& names) {
    std::string list;
    const std::string text = sdfLibrary().emit(names, "G()");
    for (const LibraryFunction& f : sdfLibrary().functions())
        if (text.find(f.signature + " {") != std::string::npos) list += f.name + " ";
    return list;
}

std::string returning(const std::string& expression) {
    return "float sdf(vec3 p) { return " + expression + "; }";
}

}  // namespace

TEST(Library, NamesAreUniqueAndFollowTheScheme) {
    std::set<std::string> names;
    for (const LibraryFunction& f : sdfLibrary().functions()) {
        EXPECT_TRUE(names.insert(f.name).second) << f.name;
        bool known = false;
        for (const char* prefix : {"sd", "sd2", "op", "dom", "noise", "slope", "num", "uv", "pat"}) {
            const size_t size = std::string_view(prefix).size();
            known = known || (f.name.compare(0, size, prefix) == 0 && f.name.size() > size &&
                              std::isupper(static_cast<unsigned char>(f.name[size])));
        }
        EXPECT_TRUE(known || f.name == "domRotate2") << f.name;
    }
    EXPECT_GT(names.size(), 150u);
}

TEST(Library, EveryFunctionIsExplained) {
    for (const LibraryFunction& f : sdfLibrary().functions()) {
        EXPECT_GT(f.about.size(), 5u) << f.name;
        const bool material = startsWith(f.where.file, "lib/material/");
        EXPECT_EQ(f.examples.empty(), material) << f.name;
        EXPECT_EQ(f.patterns.empty(), !material) << f.name;
        // A distance says how good it is, and a bound how steep.
        const bool distance =
            f.name.compare(0, 2, "sd") == 0 && f.signature.compare(0, 5, "float") == 0;
        if (distance) {
            EXPECT_NE(f.quality, LibraryFunction::Quality::kNone) << f.name;
        }
        if (f.quality != LibraryFunction::Quality::kExact && distance) {
            EXPECT_NE(f.lipschitz, "") << f.name;
        }
    }
}

TEST(Library, EmitsWhatIsUsedAndWhatThatCallsAndNothingElse) {
    EXPECT_EQ(sdfLibrary().emit({}, "G()"), "");
    EXPECT_EQ(defined({"sdSphere"}), "sdSphere ");
    EXPECT_EQ(defined({"sdTriangularPrism"}), "opExtrude sd2Polygon sdPrism sdTriangularPrism ");
    EXPECT_EQ(defined({"sdPrism", "sdTriangularPrism", "sdSphere"}),
              "opExtrude sd2Polygon sdSphere sdPrism sdTriangularPrism ");
    EXPECT_EQ(sdfLibrary().emit({"sdSphere"}, "G()"),
              "#ifndef LIBRARY_sdSphere\n#define LIBRARY_sdSphere\n"
              "float sdSphere(vec3 p, float radius) {\nreturn length(p) - radius;\n}\n#endif\n");
}

TEST(Library, LoopsAreGuarded) {
    EXPECT_NE(
        sdfLibrary().emit({"noiseFbm"}, "G()").find("for (int i = 0; G() && (i < octaves); i++)"),
        std::string::npos);
    for (const LibraryFunction& f : sdfLibrary().functions()) {
        int loops = 0, guards = 0;
        for (const SnippetPiece& piece : f.pieces) {
            loops += piece.text == "for" || piece.text == "while" ? 1 : 0;
            guards += piece.role == SnippetPiece::Role::kGuard ? 1 : 0;
        }
        EXPECT_EQ(loops, guards) << f.name;
    }
}

TEST(Library, ASnippetRemembersWhatItCalls) {
    const Snippet snippet = good(returning("opUnion(sdSphere(p, 1.0), sdTorus(p, 1.0, 0.2))"));
    EXPECT_EQ(snippet.libraryFunctions, (std::set<std::string>{"opUnion", "sdSphere", "sdTorus"}));
    EXPECT_NE(emitSnippet(snippet, shortOptions()).find("return opUnion(sdSphere(X_p, 1.0)"),
              std::string::npos);
    EXPECT_TRUE(good("void material(inout Surface s) { s.roughness = noiseValue(s.position); }",
                     SnippetKind::kMaterial)
                    .libraryFunctions.contains("noiseValue"));
}

TEST(Library, TheUsersOwnDefinitionWins) {
    const Snippet own = good("float sdSphere(vec3 p, float r) { return length(p) - r; }\n" +
                             returning("sdSphere(p, 1.0)"));
    EXPECT_TRUE(own.libraryFunctions.empty());
    EXPECT_NE(emitSnippet(own, shortOptions()).find("return X_sdSphere(X_p, 1.0)"),
              std::string::npos);
    // An overload with another number of arguments leaves the library's in place.
    const Snippet both =
        good("float sdSphere(vec3 p) { return sdSphere(p, 1.0); }\n" + returning("sdSphere(p)"));
    EXPECT_EQ(both.libraryFunctions.size(), 1u);
    EXPECT_NE(emitSnippet(both, shortOptions()).find("return X_sdSphere(X_p)"), std::string::npos);
    EXPECT_EQ(problemsOf(returning("sdSphere(p, 1.0)") +
                         "\nfloat sdSphere(vec3 p, float r) { return r; }"),
              "2:7: error: 'sdSphere' was called above, where it still meant the function of the "
              "library; declare it before its first call");
}

TEST(Library, UnknownNamesAreErrors) {
    const std::pair<std::string, const char*> table[] = {
        {returning("sdTorsu(p, 1.0, 0.2)"),
         "1:28: error: no function 'sdTorsu' (did you mean 'sdTorus'?)"},
        {returning("smothstep(0.0, 1.0, p.x)"),
         "1:28: error: no function 'smothstep' (did you mean 'smoothstep'?)"},
        {"float blob(vec3 p) { return p.x; }\n" + returning("blop(p)"),
         "2:28: error: no function 'blop' (did you mean 'blob'?)"},
        {returning("smin(p.x, p.y, 0.1)"),
         "1:28: error: no function 'smin'; the library has float opSmoothUnion(float a, float b, "
         "float width)"},
        {returning("fetchParameter(0, 0).x"), "1:28: error: no function 'fetchParameter'"},
        {returning("frame.shading.x"), "1:28: error: 'frame' is not declared"},
        {returning("length(p) - radiu"), "1:40: error: 'radiu' is not declared"},
        {"const float radius = 1.0;\n" + returning("length(p) - radiu"),
         "2:40: error: 'radiu' is not declared (did you mean 'radius'?)"},
        {returning("itime"), "1:28: error: 'itime' is not declared (did you mean 'time'?)"},
        {returning("fma(p.x, p.y, p.z)"),
         "1:28: error: 'fma' cannot be used: it does not exist in WebGL2, and a snippet has to run "
         "there too"},
        {returning("sdTorus(p, vec2(1.0, 0.2))"),
         "1:28: error: 'sdTorus' takes 3 arguments, not 2: float sdTorus(vec3 p, float ring, float "
         "tube)"},
        {"float f(float x) { return x; }\n" + returning("f(p.x, p.y)"),
         "2:28: error: no function 'f' takes that many arguments"},
        {returning("oops + oops + oops"), "1:28: error: 'oops' is not declared"},
    };
    for (const auto& [source, expected] : table) EXPECT_EQ(problemsOf(source), expected) << source;
}

TEST(Library, NamesFromElsewhereLeadSomewhere) {
    for (const char* name : {"smin", "opU", "fSphere", "pModPolar", "opOnion", "sdRoundBox", "fbm",
                             "opExtrusion", "fOpUnionStairs", "opCheapBend", "sminExp", "fDisc",
                             "checker", "checkersGradBox", "voronoi", "triplanar", "bricks"}) {
        const std::string here(Library::nameHere(name));
        EXPECT_NE(here, "") << name;
        EXPECT_NE(sdfLibrary().find(here), nullptr) << here;
    }
}

TEST(Library, AMistakeInItIsNotPassedOver) {
    const auto reading = [](std::string_view text) {
        return [text] { Library({{"a.glsl", text}}); };
    };
    EXPECT_NO_THROW(reading("float sdA(vec3 p) { return p.x; }")());
    EXPECT_THROW(reading("float sdA(vec3 p) { return q.x; }")(), std::logic_error);
    EXPECT_THROW(reading("float sdA(vec3 p) { return sdB(p); }")(), std::logic_error);
    EXPECT_THROW(reading("float sdA(vec3 p) { return p.x; } float sdA(vec2 p) { return p.x; }")(),
                 std::logic_error);
}

}  // namespace vitrine
