// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gltf/json_document.hpp"
#include "gltf/json_place.hpp"
#include "gltf/json_value.hpp"

namespace vitrine {
namespace {

constexpr JsonLimits kLimits{1000, 256};

/// The message, or "" if the text was accepted.
std::string refusal(const std::string& text, size_t firstByte = 0,
                    const JsonLimits& limits = kLimits) {
    Diagnostics diagnostics;
    Report report("m.gltf", diagnostics, 20);
    report.setJson(text, firstByte);
    const bool isGood = parseJson(text, limits, report).has_value();
    EXPECT_EQ(isGood, diagnostics.list().empty());
    return diagnostics.text();
}

TEST(GltfJson, BuildsWhatTheTextSays) {
    const std::string text = R"({"a": [1, -2, 3.5, true, null, {"b": "cé\n"}], "c": {}})";
    Diagnostics diagnostics;
    Report report("m.gltf", diagnostics, 20);
    const auto built = parseJson(text, kLimits, report);
    ASSERT_TRUE(built);
    EXPECT_EQ(*built, nlohmann::json::parse(text));
}

TEST(GltfJson, SyntaxErrorsHaveAPlace) {
    EXPECT_EQ(refusal("{\n  \"a\": 1,\n  oops\n}").substr(0, 38),
              "m.gltf:3:3: error: JSON: syntax error ");
    EXPECT_NE(refusal("[1, x]", 20).find("(at byte 24)"), std::string::npos)
        << refusal("[1, x]", 20);
    for (const char* text : {"", " ", "{", "[1,]", "nan", "[1e999]", "\"\\ud800\"", "[\"\xff\"]",
                             "{\"a\":1} x", "{'a':1}", "[01]", "\"\x01\""})
        EXPECT_NE(refusal(text), "") << text;
}

TEST(GltfJson, RepeatedKeysAreRefused) {
    EXPECT_EQ(refusal(R"({"a": {"b": 1, "b": 2}})"),
              "m.gltf: error: JSON: the key 'b' comes twice in one object");
}

TEST(GltfJson, DepthAndNumberAreLimited) {
    const auto nested = [](size_t depth) {
        return std::string(depth, '[') + std::string(depth, ']');
    };
    EXPECT_EQ(refusal(nested(256)), "");
    EXPECT_EQ(refusal(nested(257)), "m.gltf: error: JSON: nested deeper than 256 levels");
    EXPECT_EQ(refusal(std::string(5'000'000, '[')),
              "m.gltf: error: JSON: nested deeper than 256 levels");
    EXPECT_EQ(refusal("[1, 2, 3]", 0, {4, 9}), "");
    EXPECT_EQ(refusal("[1, 2, 3]", 0, {3, 9}), "m.gltf: error: JSON: more than 3 values");
}

TEST(GltfJson, PointersLeadBackToLines) {
    const std::string text =
        "{\n"
        "  \"asset\": {\"version\": \"2.0 \\\" ]}\"},\n"
        "  \"nodes\": [{}, {\"a/b\": -1.5e3, \"~\": [[], true ,{\"x\":null}]}],\n"
        "  \"end\": 7}\n";
    const auto at = [&text](const char* pointer) {
        const JsonPlace place = findJsonPlace(text, pointer);
        return std::pair(place.line, place.column);
    };
    EXPECT_EQ(at(""), std::pair(1, 1));
    EXPECT_EQ(at("/asset"), std::pair(2, 12));
    EXPECT_EQ(at("/asset/version"), std::pair(2, 24));
    EXPECT_EQ(at("/nodes/0"), std::pair(3, 13));
    EXPECT_EQ(at("/nodes/1/a~1b"), std::pair(3, 25));
    EXPECT_EQ(at("/nodes/1/~0/1"), std::pair(3, 43));
    EXPECT_EQ(at("/nodes/1/~0/2/x"), std::pair(3, 54));
    EXPECT_EQ(at("/end"), std::pair(4, 10));
    EXPECT_EQ(at("/nodes/7"), std::pair(3, 12)) << "what is missing is placed at what is around it";
    EXPECT_EQ(at("/asset/version/deeper"), std::pair(2, 24));
    EXPECT_EQ(at("/nodes/x"), std::pair(3, 12));
}

TEST(GltfJson, LookingUpPlacesInBrokenTextIsHarmless) {
    const std::string text = R"({"a": [1, {"b": "x\"y"}, [2]], "c": null})";
    for (size_t length = 0; length <= text.size(); ++length)
        for (const char* pointer : {"/a/2/0", "/c", "/a/1/b", "/d/e"})
            EXPECT_EQ(findJsonPlace(text.substr(0, length), pointer).line, 1);
}

TEST(GltfJson, WordsOfTheFileAreMadeSafeForMessages) {
    EXPECT_EQ(inQuotes("a\nb\x7f"), "'a?b?'");
    EXPECT_EQ(inQuotes(std::string(80, 'x')).size(), 82u);
    EXPECT_EQ(inQuotes(std::string(79, 'x') + "ä"), "'" + std::string(79, 'x') + "...'");
}

TEST(GltfJson, ValuesAreChecked) {
    const nlohmann::json json = nlohmann::json::parse(
        R"({"n": 2.5, "i": 3, "f": 3.0, "neg": -1, "big": 1e60, "s": "t", "b": true,
            "v": [1, 2, 3], "w": [1, "x", 3], "o": {"k": 1}})");
    Diagnostics diagnostics;
    Report report("m.glb", diagnostics, 100);
    const JsonValue value(&json, "", report);
    EXPECT_EQ(value.number("n", 0), 2.5f);
    EXPECT_EQ(value.number("none", 7), 7);
    EXPECT_EQ(value.whole("i", 0), 3u);
    EXPECT_EQ(value.whole("f", 0), 3u) << "3.0 is a whole number";
    EXPECT_EQ(value.index("i", 4), 3);
    EXPECT_EQ(value.text("s"), "t");
    EXPECT_TRUE(value.flag("b", false));
    EXPECT_EQ(value.vector<3>("v", glm::vec3(0)), glm::vec3(1, 2, 3));
    EXPECT_EQ(value.object("o").whole("k", 0), 1u);
    EXPECT_EQ(value.object("none").object("deeper").whole("k", 5), 5u);
    EXPECT_TRUE(diagnostics.list().empty()) << diagnostics.text();

    EXPECT_EQ(value.index("i", 3), -1);
    EXPECT_EQ(value.index("neg", 3), -1);
    EXPECT_EQ(value.whole("n", 9), 9u);
    EXPECT_EQ(value.whole("big", 9), 9u);
    EXPECT_EQ(value.number("s", 9), 9);
    EXPECT_EQ(value.vector<4>("v", glm::vec4(9)), glm::vec4(9));
    EXPECT_EQ(value.vector<3>("w", glm::vec3(9)), glm::vec3(9));
    EXPECT_EQ(value.text("i"), "");
    EXPECT_TRUE(value.flag("i", true));
    EXPECT_FALSE(value.object("v").exists());
    EXPECT_FALSE(value.array("o").exists());
    EXPECT_EQ(diagnostics.list().size(), 11u) << diagnostics.text();
    EXPECT_EQ(diagnostics.list()[0].text(),
              "m.glb: error: /i: 3 is out of range: the last one is 2");
    EXPECT_EQ(diagnostics.list()[6].text(), "m.glb: error: /w/1: must be a number");
}

}  // namespace
}  // namespace vitrine
