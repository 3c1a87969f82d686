// SPDX-License-Identifier: MIT
#include "sdf/kinds.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"

namespace vitrine::glsl {

namespace {

struct Kind {
    SnippetKind kind;
    std::string_view suffix;
    /// Accepted names of the entry; an earlier one wins.
    std::vector<std::string> entries;
    std::vector<std::string> returnTypes;
    std::vector<Argument> arguments;
    /// As told to users; %s is the name.
    std::string_view signature;
    /// Names that show that the file is of another kind, and what to do then.
    std::vector<std::string> foreign;
    std::string_view advice;
};

const std::array<Kind, 3>& kinds() {
    static const std::array<Kind, 3> kKinds = {{
        {SnippetKind::kField,
         ".sdf.glsl",
         {"sdf", "map", "DE"},
         {"float", "vec2"},
         {{"vec3", "in"}},
         "float %s(vec3 p), or vec2 %s(vec3 p) for (distance, part)",
         {"main", "mainImage"},
         "a distance field draws no picture: remove it, or put it inside of #ifndef VITRINE"},
        {SnippetKind::kMaterial,
         ".mat.glsl",
         {"material"},
         {"void"},
         {{"Surface", "inout"}},
         "void %s(inout Surface s)",
         {"main", "mainImage"},
         "a material draws no picture: remove it, or put it inside of #ifndef VITRINE"},
        {SnippetKind::kScreen,
         ".screen.glsl",
         {"mainImage"},
         {"void"},
         {{"vec4", "out"}, {"vec2", "in"}},
         "void %s(out vec4 color, in vec2 pixel)",
         {"main"},
         "the renderer has its own: remove it, or put it inside of #ifndef VITRINE"},
    }};
    return kKinds;
}

const Kind& row(SnippetKind kind) {
    return *std::find_if(kinds().begin(), kinds().end(),
                         [&](const Kind& k) { return k.kind == kind; });
}

// Shadertoy's names, then those of glslViewer and The Book of Shaders.
constexpr std::array<Builtin, 3> kTimes = {{
    {"time", "time", "float", ""},
    {"iTime", "time", "float", ""},
    {"u_time", "time", "float", ""},
}};
constexpr std::array<Builtin, 9> kScreenBuiltins = {{
    {"iResolution", "resolution", "vec3", ""},
    {"u_resolution", "resolution", "vec2", ".xy"},
    {"iMouse", "mouse", "vec4", ""},
    {"u_mouse", "mouse", "vec2", ".xy"},
    {"iTimeDelta", "timeDelta", "float", ""},
    {"u_delta", "timeDelta", "float", ""},
    {"iFrame", "frame", "int", ""},
    {"u_frame", "frame", "int", ""},
    {"iDate", "date", "vec4", ""},
}};

std::string withName(std::string_view pattern, const std::string& name) {
    std::string result;
    for (size_t i = 0; i < pattern.size(); ++i) {
        if (pattern.substr(i, 2) == "%s") {
            result += name;
            ++i;
        } else {
            result += pattern[i];
        }
    }
    return result;
}

bool fits(const Function& function, const Kind& kind) {
    return function.arguments == kind.arguments &&
           std::find(kind.returnTypes.begin(), kind.returnTypes.end(), function.returnType) !=
               kind.returnTypes.end();
}

}  // namespace

const Builtin* findBuiltin(SnippetKind kind, std::string_view name) {
    for (const Builtin& builtin : kTimes)
        if (builtin.name == name) return &builtin;
    if (kind != SnippetKind::kScreen) return nullptr;
    for (const Builtin& builtin : kScreenBuiltins)
        if (builtin.name == name) return &builtin;
    return nullptr;
}

std::vector<std::string> builtinNames(SnippetKind kind) {
    std::vector<std::string> names;
    for (const Builtin& builtin : kTimes) names.emplace_back(builtin.name);
    if (kind == SnippetKind::kScreen)
        for (const Builtin& builtin : kScreenBuiltins) names.emplace_back(builtin.name);
    return names;
}

void chooseEntry(std::span<const Function> functions, Snippet& snippet, Problems& problems) {
    const Kind& kind = row(snippet.kind);
    const auto known = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const Function& function : functions)
        if (known(kind.foreign, function.name))
            problems.error(function.place, "'" + function.name + "' in a " +
                                               std::string(kind.suffix) +
                                               " file: " + std::string(kind.advice));
    for (const std::string& name : kind.entries) {
        for (const Function& function : functions) {
            if (function.name != name || !function.defined || !fits(function, kind)) continue;
            snippet.entry = name;
            snippet.entryReturnsPart = function.returnType == "vec2";
            return;
        }
    }
    std::string names;
    std::string spelling;
    for (const Function& function : functions) {
        if (known(kind.entries, function.name)) {
            problems.error(function.place, "'" + function.name + "' must be " +
                                               withName(kind.signature, function.name));
            return;
        }
        const std::string near = closestMatch(function.name, kind.entries);
        if (!near.empty() && fits(function, kind))
            spelling = "; did you mean '" + function.name + "' on line " +
                       std::to_string(function.place.line) + " to be '" + near + "'?";
    }
    for (const std::string& name : kind.entries) names += (names.empty() ? "" : ", ") + name;
    problems.error(
        {1, 1}, "no entry function: define " + withName(kind.signature, kind.entries.front()) +
                    (kind.entries.size() > 1 ? " (accepted names: " + names + ")" : "") + spelling);
}

}  // namespace vitrine::glsl

namespace vitrine {

std::optional<SnippetKind> snippetKindOf(std::string_view file) {
    for (const glsl::Kind& kind : glsl::kinds())
        if (endsWith(file, kind.suffix)) return kind.kind;
    return {};
}

}  // namespace vitrine
