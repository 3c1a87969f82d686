// SPDX-License-Identifier: MIT
#include "gpu/shader_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/text.hpp"

namespace vitrine {
namespace {

std::string prelude(const ShaderKey& key) {
    std::string text;
    switch (key.dialect) {
        case Dialect::kEs300:
            text =
                "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                "precision highp sampler2D;\nprecision highp usampler2D;\nprecision highp "
                "sampler2DArray;\n#define precise\n";
            break;
        case Dialect::kGl410:
            text = "#version 410 core\n";
            break;
        case Dialect::kGl450:
            text = "#version 450 core\n";
            break;
    }
    // GLSL ES 3.00 has no buffer textures: scene data come from 2-D textures there.
    text += fmt::format("#define DIALECT_ES {}\n", key.dialect == Dialect::kEs300 ? 1 : 0);
    for (const auto& [name, value] : key.defines)
        text += fmt::format("#define {} {}\n", name, value);
    return text;
}

std::string_view stageSuffix(ShaderStage stage) {
    switch (stage) {
        case ShaderStage::kVertex:
            return "vert";
        case ShaderStage::kFragment:
            return "frag";
        case ShaderStage::kCompute:
            return "comp";
    }
    return "";
}

class Assembler {
  public:
    explicit Assembler(const GeneratedIncludes& generated) : generated_(generated) {}

    void addLine(std::string_view line, SourceLocation place) {
        result_.text.append(line);
        result_.text += '\n';
        result_.places.push_back(std::move(place));
    }

    void addFile(const std::string& name, const std::string& includedFrom) {
        if (!done_.insert(name).second) return;
        const auto made = generated_.find(name);
        if (made != generated_.end()) {
            addGenerated(name, made->second);
            return;
        }
        int number = 0;
        for (const std::string_view line : splitLines(find(name, includedFrom))) {
            ++number;
            const std::string_view words = trim(line);
            if (startsWith(words, "#include")) {
                const size_t open = words.find('"'), close = words.rfind('"');
                addFile(std::string(words.substr(open + 1, close - open - 1)), name);
            } else {
                addLine(line, {name, number, 0});
            }
        }
    }

    [[nodiscard]] AssembledShader take() { return std::move(result_); }

  private:
    void addGenerated(const std::string& name, const std::string& text) {
        int number = 0;
        for (const std::string_view line : splitLines(text)) addLine(line, {name, ++number, 0});
        // The text may have renumbered its lines: return to the numbering of the whole.
        addLine(fmt::format("#line {}", result_.places.size() + 2), {name, number, 0});
    }

    static std::string_view find(const std::string& name, const std::string& includedFrom) {
        const auto& files = embeddedShaders();
        const auto file = std::find_if(files.begin(), files.end(),
                                       [&](const EmbeddedFile& f) { return f.name == name; });
        if (file == files.end())
            throw std::logic_error(fmt::format(
                "shader file '{}' (included from '{}') does not exist", name, includedFrom));
        return file->text;
    }

    const GeneratedIncludes& generated_;
    std::set<std::string> done_;
    AssembledShader result_;
};

}  // namespace

std::string ShaderKey::text() const {
    std::string result = fmt::format("{}.{}", entry, stageSuffix(stage));
    for (const auto& [name, value] : defines) result += fmt::format(" {}={}", name, value);
    return result;
}

AssembledShader assembleShader(const ShaderKey& key, const GeneratedIncludes& generated) {
    Assembler assembler(generated);
    const std::string head = prelude(key);
    for (const std::string_view line : splitLines(head)) assembler.addLine(line, {"prelude", 0, 0});
    assembler.addFile(fmt::format("entry/{}.{}.glsl", key.entry, stageSuffix(key.stage)), "");
    return assembler.take();
}

}  // namespace vitrine
