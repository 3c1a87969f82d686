// SPDX-License-Identifier: MIT
// Every shader entry, in every variant and dialect there is, is accepted by glslang: no GPU needed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/session/session.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "frame/programs.hpp"

namespace vitrine {
namespace fs = std::filesystem;
namespace {

struct Target {
    ShaderStage stage;
    Dialect dialect;
    const char* glslangStage;
};

constexpr Target kTargets[] = {{ShaderStage::kVertex, Dialect::kEs300, "vert"},
                               {ShaderStage::kVertex, Dialect::kGl410, "vert"},
                               {ShaderStage::kFragment, Dialect::kEs300, "frag"},
                               {ShaderStage::kFragment, Dialect::kGl410, "frag"},
                               {ShaderStage::kFragment, Dialect::kGl450, "frag"},
                               {ShaderStage::kCompute, Dialect::kGl450, "comp"}};

bool entryExists(const std::string& pass, ShaderStage stage) {
    const std::string suffix = stage == ShaderStage::kCompute  ? "comp"
                               : stage == ShaderStage::kVertex ? "vert"
                                                               : "frag";
    for (const EmbeddedFile& file : embeddedShaders())
        if (file.name == fmt::format("entry/{}.{}.glsl", pass, suffix)) return true;
    return false;
}

/// What glslang says; empty if it is content.
std::string validate(const std::string& text, const char* stage, const fs::path& folder) {
    const fs::path file = folder / (std::string("shader.") + stage);
    writeFileAtomically(file, text);
    const std::string command =
        fmt::format("glslangValidator -S {} '{}' 2>&1", stage, file.string());
    FILE* pipe = ::popen(command.c_str(), "r");
    std::string output;
    char buffer[4096];
    while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) output += buffer;
    return ::pclose(pipe) == 0 ? "" : output;
}

/// Snippets of real scenes, so that their renamed text is checked with ours.
GeneratedShaders snippetsOfTheLessons() {
    Diagnostics diagnostics;
    std::vector<std::shared_ptr<const Snippet>> fields, materials;
    for (const char* file : {"scenes/lesson-both.toml", "scenes/lesson-march.toml"}) {
        const LoadedScene loaded = loadAll(file, {}, diagnostics);
        for (const auto& field : loaded.assets.fields)
            if (field != nullptr) fields.push_back(field);
        for (const auto& material : loaded.assets.materials)
            if (material != nullptr) materials.push_back(material);
    }
    EXPECT_EQ(diagnostics.text(), "");
    EXPECT_EQ(fields.size(), 3u);
    EXPECT_EQ(materials.size(), 1u);
    return generateShaders(fields, materials);
}

class ShaderDialects : public testing::Test {
  protected:
    void SetUp() override {
        if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
            GTEST_SKIP() << "glslangValidator is not installed";
        std::string name = fs::temp_directory_path() / "vitrine-shader-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override {
        if (!folder.empty()) fs::remove_all(folder);
    }
    /// How often the text of a pass's fragment shader holds this, white space aside, when it has
    /// been preprocessed.
    int occurrences(const std::string& pass, const ProgramFeatures& features,
                    const std::string& mark) {
        if (generated_.includes.empty()) generated_ = snippetsOfTheLessons();
        const ShaderKey key = shaderKey(pass, features, ShaderStage::kFragment, Dialect::kGl450);
        const fs::path file = folder / "shader.frag", out = folder / "preprocessed";
        writeFileAtomically(file, assembleShader(key, generated_.includes).text);
        EXPECT_EQ(
            std::system(fmt::format("glslangValidator -E '{}' > '{}'", file.string(), out.string())
                            .c_str()),
            0);
        std::string text = readFile(out, 1 << 22);
        std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
        int n = 0;
        for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1))
            ++n;
        return n;
    }

    fs::path folder;

  private:
    GeneratedShaders generated_;
};

}  // namespace

TEST_F(ShaderDialects, AllVariantsAreAccepted) {
    const GeneratedShaders generated = snippetsOfTheLessons();
    int compiled = 0;
    ProgramFeatures everything{true, true, true, true};
    everything.layers = everything.transmission = everything.filters = everything.culling = true;
    everything.sky = everything.subsurface = everything.cones = true;
    everything.classic = everything.curvature = true;
    ProgramFeatures conesAlone;
    conesAlone.cones = true;
    for (const PassShader& pass : passShaders())
        for (const Target& target : kTargets) {
            if (!entryExists(pass.name, target.stage)) continue;
            for (const ProgramFeatures& features :
                 {ProgramFeatures{true, true, false}, ProgramFeatures{true, true, true},
                  ProgramFeatures{true, false, false}, ProgramFeatures{false, true, false},
                  conesAlone, everything}) {
                if (!pass.traces && !features.textures &&
                    (!features.meshes || !features.fields || features.counters))
                    continue;
                ShaderKey key = shaderKey(pass.name, features, target.stage, target.dialect);
                if (pass.name == "march") key.defines["ONLY_FIELD"] = 1;
                const std::string log = validate(assembleShader(key, generated.includes).text,
                                                 target.glslangStage, folder);
                EXPECT_EQ(log, "")
                    << key.text() << " for dialect " << static_cast<int>(target.dialect);
                ++compiled;
            }
        }
    EXPECT_GT(compiled, 60);
}

TEST_F(ShaderDialects, WhoHasNeitherTextbookMaterialsNorCurvatureHasNoTextOfThem) {
    ProgramFeatures plain, both;
    both.classic = both.curvature = true;
    EXPECT_EQ(occurrences("visibility", plain, "kBending"), 0);
    EXPECT_GT(occurrences("visibility", both, "kBending"), 0);
    EXPECT_EQ(occurrences("bounce", plain, "kBending"), 0);
    EXPECT_GT(occurrences("bounce", both, "kBending"), 0);
    EXPECT_EQ(occurrences("light", plain, "s.shininess)"), 0);
    EXPECT_GT(occurrences("light", both, "s.shininess)"), 0);
    // A function that nobody calls costs nothing; a call does.
    EXPECT_EQ(occurrences("light", plain, "triangleCurvature("), 1);
    EXPECT_EQ(occurrences("light", both, "triangleCurvature("), 2);
}

// So that fields cost a scene of meshes nothing, and meshes a scene of fields.
TEST_F(ShaderDialects, WhoHasNoFieldsHasNoTextOfThemAndWhoHasNoMeshesCallsNone) {
    ProgramFeatures both, meshes, fields;
    fields.meshes = meshes.fields = false;
    for (const char* pass : {"visibility", "bounce", "light", "query_any"}) {
        SCOPED_TRACE(pass);
        EXPECT_EQ(occurrences(pass, meshes, "evaluateField("), 0);
        EXPECT_GT(occurrences(pass, both, "evaluateField("), 1);
        EXPECT_EQ(occurrences(pass, meshes, "marchField("), 0);
        EXPECT_EQ(occurrences(pass, fields, "intersectTriangle("), 1);
        EXPECT_EQ(occurrences(pass, both, "intersectTriangle("), 2);
    }
}

TEST_F(ShaderDialects, AMistakeIsNoticed) {
    GeneratedShaders generated = generateShaders({}, {});
    generated.includes["generated/field.glsl"] += "float planted() { return 1 + bitCount(3.0); }\n";
    const ShaderKey key = shaderKey("visibility", {}, ShaderStage::kFragment, Dialect::kEs300);
    EXPECT_NE(validate(assembleShader(key, generated.includes).text, "frag", folder), "");
}

TEST(ShaderEntries, EveryEntryBelongsToAPass) {
    std::set<std::string> known{"fullscreen"};
    for (const PassShader& pass : passShaders()) known.insert(pass.name);
    for (const EmbeddedFile& file : embeddedShaders()) {
        if (!startsWith(file.name, "entry/")) continue;
        const std::string_view name = file.name.substr(6);
        EXPECT_EQ(known.count(std::string(name.substr(0, name.find('.')))), 1u) << file.name;
    }
}

}  // namespace vitrine
