// SPDX-License-Identifier: MIT
#include "gpu/shader_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"

namespace vitrine {

TEST(ShaderSource, PlacesMatchTheText) {
    const GeneratedIncludes generated{{"entry/test.frag.glsl", "a\n#line 100001\nb\nc\n"}};
    const AssembledShader shader =
        assembleShader({"test", ShaderStage::kFragment, Dialect::kGl450, {{"X", 3}}}, generated);
    const auto lines = splitLines(shader.text);
    ASSERT_EQ(lines.size(), shader.places.size());
    EXPECT_EQ(lines[0], "#version 450 core");
    EXPECT_NE(shader.text.find("#define X 3\n"), std::string::npos);
    const auto line = std::find(lines.begin(), lines.end(), "c") - lines.begin();
    EXPECT_EQ(shader.places[static_cast<size_t>(line)].text(), "entry/test.frag.glsl:4");
    // The directive after generated text gives the following line its own number again.
    EXPECT_EQ(lines.back(), "#line " + std::to_string(lines.size() + 1));
}

TEST(ShaderSource, MissingIncludeNamesBothFiles) {
    try {
        (void)assembleShader({"no-such-entry", ShaderStage::kCompute, Dialect::kGl450, {}}, {});
        FAIL();
    } catch (const std::logic_error& e) {
        EXPECT_NE(std::string(e.what()).find("entry/no-such-entry.comp.glsl"), std::string::npos);
    }
}

TEST(ShaderSource, IncludesAreOnceOnlyAndEsHasPrecision) {
    for (const EmbeddedFile& file : embeddedShaders()) {
        if (!startsWith(file.name, "entry/") || !endsWith(file.name, ".frag.glsl")) continue;
        const std::string entry(file.name.substr(6, file.name.size() - 6 - 10));
        const AssembledShader shader =
            assembleShader({entry, ShaderStage::kFragment, Dialect::kEs300, {}},
                           {{"generated/field.glsl", ""}, {"generated/material.glsl", ""}});
        EXPECT_TRUE(startsWith(shader.text, "#version 300 es\nprecision highp float;")) << entry;
        EXPECT_EQ(shader.text.find("#include"), std::string::npos) << entry;
        EXPECT_EQ(shader.text.find("void main()"), shader.text.rfind("void main()")) << entry;
    }
}

}  // namespace vitrine
