// SPDX-License-Identifier: MIT
// From a shader's name to the text that the driver gets: prelude, includes, place of each line.
//
// Every shader is one text for three dialects (docs/architecture.md). `#version`, precision and
// defines come from the prelude written here and from nowhere else. An include is pasted once. No
// #line directive names a file, because Mesa loses the source number in some messages; the
// assembled text is numbered as one piece and a table maps its lines back.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/embedded_file.hpp"
#include "base/error.hpp"

namespace vitrine {

/// All files of shaders/ but those of lib/sdf, which sdf/library.hpp knows, in the order of their
/// names. Generated at build time.
const std::vector<EmbeddedFile>& embeddedShaders();

enum class ShaderStage { kVertex, kFragment, kCompute };
enum class Dialect { kEs300, kGl410, kGl450 };

/// Names one shader: shaders/entry/ENTRY.{vert,frag,comp}.glsl with defines, each 0 or a number.
struct ShaderKey {
    std::string entry;
    ShaderStage stage = ShaderStage::kFragment;
    Dialect dialect = Dialect::kGl450;
    std::map<std::string, int> defines;

    /// "visibility.frag [COUNTERS=1]", for messages.
    [[nodiscard]] std::string text() const;
};

/// Text made at run time, by the name under which a shader includes it ("generated/field.glsl").
/// Lines of it that stand under a `#line` directive keep the numbers given there.
using GeneratedIncludes = std::map<std::string, std::string>;

struct AssembledShader {
    std::string text;
    /// The place of line i + 1 of `text`.
    std::vector<SourceLocation> places;
};

/// Throws std::logic_error on a missing include: shaders are part of the program.
AssembledShader assembleShader(const ShaderKey& key, const GeneratedIncludes& generated);

}  // namespace vitrine
