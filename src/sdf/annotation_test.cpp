// SPDX-License-Identifier: MIT
#include "sdf/annotation.hpp"

#include <gtest/gtest.h>

#include "sdf/test_support.hpp"

namespace vitrine {

namespace {

const std::string kEntry = "\nfloat sdf(vec3 p) { return 0.0; }\n";

Parameter only(const std::string& line) {
    const Snippet snippet = good(line + kEntry);
    return snippet.parameters.size() == 1 ? snippet.parameters[0] : Parameter{};
}

std::string problems(const std::string& line) {
    return problemsOf(line + kEntry);
}

}  // namespace

TEST(Annotation, SliderIsMinDefaultMax) {
    for (const char* line : {"uniform float r; // slider[-1, 0.5, 2.5e0] Big radius",
                             "uniform float r; slider[-1,0.5,2.5] Big radius",
                             "uniform float r; //! slider[-1.0f, .5, 2.5]   Big radius  ",
                             "uniform highp float r; /* slider[ -1. ,0.5, +2.5] Big radius */",
                             "uniform float r;slider[-1,0.5,2.5] Big radius // not in the label"}) {
        const Parameter p = only(line);
        EXPECT_EQ(p.name, "r") << line;
        EXPECT_EQ(p.type, ParameterType::kFloat);
        EXPECT_EQ(p.minimum.x, -1.0f) << line;
        EXPECT_EQ(p.defaultValue.x, 0.5f);
        EXPECT_EQ(p.maximum.x, 2.5f);
        EXPECT_EQ(p.label, "Big radius") << line;
        EXPECT_TRUE(p.ranged);
        EXPECT_EQ(p.where.line, 1);
    }
}

TEST(Annotation, SliderOfVectors) {
    const Parameter p = only("uniform vec3 v; // slider[(0,0,0),(1,2,3),(4,4,4)]");
    EXPECT_EQ(p.type, ParameterType::kVec3);
    EXPECT_EQ(glm::vec3(p.defaultValue), glm::vec3(1, 2, 3));
    EXPECT_EQ(glm::vec3(p.maximum), glm::vec3(4));
    EXPECT_EQ(p.label, "v") << "the name stands in for a label";
    EXPECT_EQ(only("uniform vec2 v; // slider[0, 0.5, 1]").defaultValue.y, 0.5f);
    EXPECT_EQ(only("uniform int n; // slider[1, 3, 9]").defaultValue.x, 3.0f);
}

TEST(Annotation, ColorAndCheckbox) {
    const Parameter c = only("uniform vec3 tint; // color[0.8, 0.3, 0.2] Glaze");
    EXPECT_EQ(c.type, ParameterType::kColor);
    EXPECT_EQ(glm::vec3(c.defaultValue), glm::vec3(0.8f, 0.3f, 0.2f));
    EXPECT_EQ(only("uniform bool b; // checkbox[true]").defaultValue.x, 1.0f);
    EXPECT_EQ(only("uniform bool b;").defaultValue.x, 0.0f);
}

TEST(Annotation, DescribesAllUniformsThatEndOnItsLine) {
    const Snippet s = good(
        "uniform float a, b; // slider[0,1,2]\nuniform float c, // slider[0,3,4]\n"
        "  d; // slider[0,5,6]" +
        kEntry);
    ASSERT_EQ(s.parameters.size(), 4u);
    EXPECT_EQ(s.parameters[1].defaultValue.x, 1.0f);
    EXPECT_EQ(s.parameters[2].defaultValue.x, 3.0f);
    EXPECT_EQ(s.parameters[3].defaultValue.x, 5.0f);
}

TEST(Annotation, OfTheSnippet) {
    const Snippet s = good(
        "// bounds[-1,-2,-3, 1,2,3]\n//lipschitz[1.4]\n/* parts[a, b-2] */\n"
        "vec2 sdf(vec3 p) { return vec2(0.0); }");
    ASSERT_TRUE(s.bounds && s.lipschitz);
    EXPECT_EQ(s.bounds->min, glm::vec3(-1, -2, -3));
    EXPECT_EQ(s.bounds->max, glm::vec3(1, 2, 3));
    EXPECT_EQ(*s.lipschitz, 1.4f);
    EXPECT_EQ(s.partNames, (std::vector<std::string>{"a", "b-2"}));
}

TEST(Annotation, Groups) {
    const Snippet s = good(
        "uniform bool a;\n#group Shape of it\nuniform bool b;\n// group Look\n"
        "uniform bool c;\n// group[Two words]\nuniform bool d;\n"
        "//! <group name=\"S\">\nuniform bool e;" +
        kEntry);
    ASSERT_EQ(s.parameters.size(), 5u);
    EXPECT_EQ(s.parameters[0].group, "");
    EXPECT_EQ(s.parameters[1].group, "Shape of it");
    EXPECT_EQ(s.parameters[2].group, "Look");
    EXPECT_EQ(s.parameters[3].group, "Two words");
    EXPECT_EQ(s.parameters[4].group, "S");
}

TEST(Annotation, ProseIsLeftAlone) {
    for (const char* prose :
         {"// slider: see below", "// the bounds[0, 1] are odd", "// a[0] is first, b[1] second",
          "// group the balls by size", "// color of the thing", "// [1, 2, 3]",
          "// array[i] of things", "/* slider\n[0,1,2] */", "// index[3] and more",
          "// slider [0, 1, 2]", "#if 0\nuniform float r; // sldier[0,\n// bounds[x]\n#endif"})
        EXPECT_EQ(problems(prose), "") << prose;
}

TEST(Annotation, MistakesHaveAPlaceAndSayTheForm) {
    const std::pair<const char*, const char*> table[] = {
        {"uniform float r; // sldier[0, 1, 2]",
         "1:21: error: unknown annotation 'sldier' (did you mean 'slider'?)"},
        {"// bound[0,0,0,1,1,1]",
         "1:4: warning: 'bound[' is no annotation (did you mean 'bounds'?)"},
        {"// slider[0, 1, 2]\nuniform bool r;",
         "1:4: error: slider describes no uniform: it belongs on the line where one ends"},
        {"uniform float r; // slider[0, 1]",
         "1:21: error: slider has 2 values; expected slider[min, default, max]"},
        {"uniform float r; // slider[0, 1, 2",
         "1:21: error: slider has no closing ']'; expected slider[min, default, max]"},
        {"uniform float r; // slider[0, x, 2]",
         "1:31: error: 'x' is not a number; expected slider[min, default, max]"},
        {"uniform float r; // slider[0, , 2]",
         "1:31: error: a number is missing; expected slider[min, default, max]"},
        {"uniform float r; // slider[0, nan, 2]",
         "1:31: error: 'nan' is not a number; expected slider[min, default, max]"},
        {"uniform float r; // slider[0, 1, 1e39]",
         "1:34: error: '1e39' is too large or too small; expected slider[min, default, max]"},
        {"uniform float r; // slider[0, 2, 1]",
         "1:31: error: the default is outside of the range; the order is min, DEFAULT, max"},
        {"uniform float r; // slider[1, 1, 0]",
         "1:28: error: the minimum is above the maximum; the order is min, DEFAULT, max"},
        {"uniform int n; // slider[0, 0.5, 1]",
         "1:29: error: '0.5' is not a whole number below 2^24, and 'n' is an int"},
        {"uniform vec2 v; // slider[(0,0,0),(1,1,1),(2,2,2)]",
         "1:27: error: a vec2 takes 2 numbers, not 3; expected slider[(minX,minY), "
         "(defaultX,defaultY), (maxX,maxY)]"},
        {"uniform bool b; // slider[0,0,1]",
         "1:20: error: slider is for float, int, vec2, vec3 or vec4, and 'b' is a bool"},
        {"uniform float f; // color[0,0,1]", "1:21: error: color is for vec3, and 'f' is a float"},
        {"uniform vec3 c; // color[0,0,2]",
         "1:30: error: a colour lies between 0 and 1; expected color[red, green, blue]"},
        {"uniform bool b; // checkbox[maybe]",
         "1:20: error: checkbox is on or off; expected checkbox[true] or checkbox[false]"},
        {"uniform float r;",
         "1:15: warning: 'r' has no range; write behind it: // slider[min, default, max] label"},
        {"// bounds[0,0,0,1,1]",
         "1:4: error: bounds has 5 values; expected bounds[minX, minY, minZ, maxX, maxY, maxZ]"},
        {"// bounds[0,0,0,1,0,1]",
         "1:13: error: the minimum is not below the maximum; expected bounds[minX, minY, minZ, "
         "maxX, maxY, maxZ]"},
        {"// bounds[0,0,0,1,1,1]\n// bounds[0,0,0,1,1,1]",
         "2:4: error: the bounds are given twice"},
        {"// lipschitz[0]",
         "1:14: error: the largest slope of the field lies above 0 and up to 1000; expected "
         "lipschitz[1.4]"},
        {"// parts[a, a]", "1:13: error: two parts are called 'a'"},
        {"// parts[a, b c]",
         "1:13: error: the name of a part has letters, digits, _ and -; expected parts[body, "
         "eyes]"},
        {"// parts[a]",
         "1:1: warning: parts[...] has no effect: 'sdf' returns only a distance, not "
         "vec2(distance, "
         "part)"},
    };
    for (const auto& [source, expected] : table) EXPECT_EQ(problems(source), expected) << source;
}

TEST(Annotation, UnrangedUniformsGetAGuess) {
    const Parameter p = only("uniform int n;");
    EXPECT_FALSE(p.ranged);
    EXPECT_EQ(p.minimum.x, 0.0f);
    EXPECT_EQ(p.defaultValue.x, 0.0f) << "what GL gives";
    EXPECT_EQ(p.maximum.x, 10.0f);
}

}  // namespace vitrine
