// SPDX-License-Identifier: MIT
// What is emitted has to be GLSL, in the oldest and in the newest dialect: glslangValidator judges.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "sdf/library.hpp"
#include "sdf/test_samples.hpp"
#include "sdf/test_support.hpp"

namespace vitrine {

namespace {

namespace fs = std::filesystem;

EmitOptions options(int snippet) {
    EmitOptions o;
    o.prefix = "s" + std::to_string(snippet) + "_";
    o.lineBase = 100'000 * (snippet + 1);
    o.parameter = [](const Parameter& p, int index) {
        const std::string value = "parameters[" + std::to_string(index) + "]." +
                                  std::string("xyzw", static_cast<size_t>(componentCount(p.type)));
        if (p.type == ParameterType::kInt) return "int(" + value + ")";
        return p.type == ParameterType::kBool ? "(" + value + " != 0.0)" : value;
    };
    o.builtins = {{"time", "clock.x"}, {"frame", "int(clock.y)"}, {"resolution", "size.xyz"},
                  {"mouse", "size"},   {"date", "size"},          {"timeDelta", "clock.z"}};
    return o;
}

constexpr const char* kPrelude = R"(
uniform vec4 parameters[64];
uniform vec4 clock, size;
int loopsLeft = 1000;
bool loopGuard() { return loopsLeft-- > 0; }
struct Surface { vec3 position; vec3 color; float roughness; };
)";

std::string callOf(const Snippet& snippet, const std::string& prefix) {
    const std::string name = emittedName(prefix, snippet.entry);
    switch (snippet.kind) {
        case SnippetKind::kField: {
            const char* component = snippet.entryReturnsPart ? ".x" : "";
            return "result += vec4(" + name + "(clock.xyz)" + component + ");\n";
        }
        case SnippetKind::kMaterial:
            return "{ Surface s; " + name + "(s); result.xyz += s.color; }\n";
        case SnippetKind::kScreen:
            return name + "(result, clock.xy);\n";
    }
    return {};
}

/// One program with all the samples twice, under different prefixes.
std::string program(const std::string& head, const std::string& tail) {
    std::string text = head + kPrelude;
    std::string calls;
    int index = 0;
    for (int round = 0; round < 2; ++round) {
        for (const Sample& sample : kSamples) {
            const Snippet snippet = good(sample.source, sample.kind);
            text += emitSnippet(snippet, options(index));
            calls += callOf(snippet, options(index).prefix);
            ++index;
        }
    }
    return text + "#line 1\nvoid main() {\nvec4 result = vec4(0.0);\n" + calls + tail + "}\n";
}

std::string validated(const std::string& text, const std::string& stage) {
    const fs::path folder = fs::temp_directory_path() / ("vitrine_sdf_" + std::to_string(getpid()));
    fs::create_directories(folder);
    const fs::path file = folder / ("test." + stage), log = folder / "log";
    std::ofstream(file) << text;
    const std::string command =
        "glslangValidator '" + file.string() + "' > '" + log.string() + "' 2>&1";
    const int status = std::system(command.c_str());
    std::ifstream in(log);
    const std::string output((std::istreambuf_iterator<char>(in)), {});
    fs::remove_all(folder);
    return status == 0 ? "" : output;
}

bool missing() {
    return std::system("glslangValidator --version > /dev/null 2>&1") != 0;
}

}  // namespace

TEST(Dialect, Compute450) {
    if (missing()) GTEST_SKIP() << "glslangValidator is not installed";
    EXPECT_EQ(validated(program("#version 450\nlayout(local_size_x = 8) in;\n"
                                "layout(std430, binding = 0) buffer Out { vec4 o[]; };\n",
                                "o[0] = result;\n"),
                        "comp"),
              "");
}

TEST(Dialect, FragmentEs300) {
    if (missing()) GTEST_SKIP() << "glslangValidator is not installed";
    EXPECT_EQ(validated(program("#version 300 es\nprecision highp float;\nprecision highp int;\n"
                                "out vec4 color;\n",
                                "color = result;\n"),
                        "frag"),
              "");
}

TEST(Dialect, TheWholeLibrary) {
    if (missing()) GTEST_SKIP() << "glslangValidator is not installed";
    std::set<std::string> names;
    for (const LibraryFunction& f : sdfLibrary().functions()) names.insert(f.name);
    const std::string text = kPrelude + sdfLibrary().emit(names, "loopGuard()") +
                             "void main() { vec4 result = vec4(sdSphere(clock.xyz, 1.0)); ";
    EXPECT_EQ(validated("#version 300 es\nprecision highp float;\nprecision highp int;\n"
                        "out vec4 color;\n" +
                            text + "color = result; }\n",
                        "frag"),
              "");
    EXPECT_EQ(validated("#version 450\nlayout(local_size_x = 8) in;\n"
                        "layout(std430, binding = 0) buffer Out { vec4 o[]; };\n" +
                            text + "o[0] = result; }\n",
                        "comp"),
              "");
}

TEST(Dialect, ErrorsNameTheUsersLine) {
    if (missing()) GTEST_SKIP() << "glslangValidator is not installed";
    const Snippet snippet = good("// one\nfloat sdf(vec3 p) {\n\n    return p.oops;\n}\n");
    const std::string log = validated("#version 450\n" + emitSnippet(snippet, options(4)) +
                                          "void main() { s4_sdf(vec3(0.0)); }\n",
                                      "frag");
    EXPECT_NE(log.find("ERROR: 0:500004: 'oops'"), std::string::npos) << log;
}

}  // namespace vitrine
