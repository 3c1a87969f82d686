// SPDX-License-Identifier: MIT
// A GLSL file written by a user: a distance field, a material or a screen. This reads it, so that
// several can live in one program and none of them can take the renderer down.
// Macros and #if are resolved here; the rest is left to the GLSL compiler, whose messages
// compile_log.hpp leads back to the user's lines.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/aabb.hpp"
#include "base/error.hpp"
#include "base/math.hpp"

namespace vitrine {

enum class SnippetKind { kField, kMaterial, kScreen };

/// The kind that a file's name ends in: ".sdf.glsl", ".mat.glsl" or ".screen.glsl".
std::optional<SnippetKind> snippetKindOf(std::string_view file);

enum class ParameterType { kFloat, kInt, kBool, kVec2, kVec3, kVec4, kColor };

/// Number of floats that hold a value of the type (a bool is 0 or 1).
int componentCount(ParameterType type);
/// As written in GLSL: "vec3" for kVec3 and kColor.
std::string_view glslName(ParameterType type);

/// A uniform: something that a slider, an animation or a scene file may set.
struct Parameter {
    std::string name;
    ParameterType type = ParameterType::kFloat;
    /// Only the first componentCount(type) numbers mean something.
    glm::vec4 minimum{0.0f}, defaultValue{0.0f}, maximum{1.0f};
    /// For people: what stands behind the annotation, or the name.
    std::string label;
    std::string group;
    SourceLocation where;
    /// The user gave the range. If not, it is only a guess for the panel, and no value is wrong.
    bool ranged = false;
};

/// A part of the text to be emitted.
struct SnippetPiece {
    enum class Role {
        kText,       // as it stands
        kName,       // declared by the snippet: gets the prefix
        kParameter,  // the value of parameters[index]
        kBuiltin,    // time and the like; `text` is the key into EmitOptions::builtins
        kGuard,      // the condition that bounds a loop
    };
    Role role = Role::kText;
    std::string text;
    int index = 0;
    int line = 1;
    int column = 1;
    bool spaceBefore = false;
};

struct Snippet {
    std::string file;
    SnippetKind kind = SnippetKind::kField;
    /// Name of the function to be called, as the user wrote it.
    std::string entry;
    /// The field returns vec2(distance, part).
    bool entryReturnsPart = false;
    std::vector<Parameter> parameters;
    std::optional<Aabb> bounds;
    /// Largest slope of the field, as promised by the user.
    std::optional<float> lipschitz;
    /// What sampling has found where the user wrote nothing (field_report.hpp).
    std::optional<Aabb> foundBounds;
    std::optional<float> measuredLipschitz;
    std::vector<std::string> partNames;
    bool usesTime = false;
    /// What it calls of the library (sdf/library.hpp).
    std::set<std::string> libraryFunctions;
    std::string source;
    std::vector<SnippetPiece> pieces;

    /// The user's bounds, or those found. Nothing if there are neither.
    [[nodiscard]] const std::optional<Aabb>& box() const { return bounds ? bounds : foundBounds; }
    /// What steps are divided by: the user's word, what was measured, or 1.
    [[nodiscard]] float stepDivisor() const {
        return lipschitz.value_or(measuredLipschitz.value_or(1.0f));
    }
};

/// Reads a snippet. Returns nothing if there are errors, which are added to `diagnostics` with
/// their places. Bad input of any kind neither throws nor takes long.
std::optional<Snippet> parseSnippet(std::string_view source, const std::string& file,
                                    SnippetKind kind, Diagnostics& diagnostics);

}  // namespace vitrine
