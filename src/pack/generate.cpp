// SPDX-License-Identifier: MIT
#include "pack/generate.hpp"

#include <fmt/format.h>

#include <set>

#include "sdf/library.hpp"

namespace vitrine {
namespace {

/// Iterations that the loops of a snippet may take together in one call.
constexpr int kLoopBudget = 1024;

constexpr const char* kGuard =
    "#ifndef SNIPPET_GUARD\n"
    "#define SNIPPET_GUARD\n"
    "float snippetTime = 0.0;\n"
    "int snippetLoops = 0;\n"
    "bool snippetLoop() {{\n"
    "    snippetLoops++;\n"
    "    return snippetLoops <= {} && mayLoop();\n"
    "}}\n"
    "#endif\n";

/// What stands before the snippets: the guard of their loops and what they call of the library.
/// Each part is there once in a program, though fields and materials may both need it.
std::string preamble(const std::vector<std::shared_ptr<const Snippet>>& snippets) {
    std::set<std::string> names;
    for (const auto& snippet : snippets)
        names.insert(snippet->libraryFunctions.begin(), snippet->libraryFunctions.end());
    return fmt::format(kGuard, kLoopBudget) + sdfLibrary().emit(names, "snippetLoop()");
}

std::string globalName(const std::string& prefix, int index) {
    return fmt::format("{}value{}", prefix, index);
}

/// A program for one of the fields alone defines its number (frame/programs.hpp).
constexpr const char* kAllFields = "#ifndef ONLY_FIELD\n#define ONLY_FIELD -1\n#endif\n";

std::string unlessLeftOut(size_t field, const std::string& text) {
    return fmt::format("#if ONLY_FIELD < 0 || ONLY_FIELD == {}\n{}#endif\n", field, text);
}

/// Globals that hold the parameters while a snippet runs, and the function that fills them. They
/// are read once an instance, not once a call: reading is dear inside a marching loop.
std::string bindFunction(const Snippet& snippet, const std::string& values,
                         const std::string& name) {
    std::string globals, body;
    for (size_t i = 0; i < snippet.parameters.size(); ++i) {
        const ParameterType type = snippet.parameters[i].type;
        const std::string global = globalName(values, static_cast<int>(i));
        globals += fmt::format("{} {};\n", glslName(type), global);
        const std::string fetch = fmt::format("fetchParameter(base, {})", i);
        static constexpr const char* kSwizzles[] = {"", ".x", ".xy", ".xyz", ""};
        std::string value = fetch + kSwizzles[componentCount(type)];
        if (type == ParameterType::kInt) value = fmt::format("int({})", value);
        if (type == ParameterType::kBool) value = fmt::format("{} > 0.5", value);
        body += fmt::format("    {} = {};\n", global, value);
    }
    return globals + fmt::format("void {}(int base) {{\n{}}}\n", name, body);
}

/// Emits one snippet with its parameters; remembers it for messages.
std::string emit(const std::shared_ptr<const Snippet>& snippet, const std::string& tag,
                 GeneratedShaders& out) {
    EmitOptions options;
    options.prefix = tag + "_";
    options.lineBase = lineBaseOf(static_cast<int>(out.snippets.size()));
    options.parameter = [values = tag + "v"](const Parameter&, int index) {
        return globalName(values, index);
    };
    options.builtins["time"] = "snippetTime";
    options.loopGuard = "snippetLoop()";
    std::string text = bindFunction(*snippet, tag + "v", tag + "bind");
    text += emitSnippet(*snippet, options);
    out.snippets.push_back({snippet, std::move(options)});
    return text;
}

}  // namespace

GeneratedShaders generateShaders(const std::vector<std::shared_ptr<const Snippet>>& fields,
                                 const std::vector<std::shared_ptr<const Snippet>>& materials) {
    GeneratedShaders out;
    std::string text = kAllFields + preamble(fields);
    std::string bind, call;
    for (size_t i = 0; i < fields.size(); ++i) {
        const std::string tag = fmt::format("f{}", i);
        text += unlessLeftOut(i, emit(fields[i], tag, out));
        const std::string entry = emittedName(tag + "_", fields[i]->entry);
        const std::string value =
            fields[i]->entryReturnsPart ? entry + "(p)" : fmt::format("vec2({}(p), 0.0)", entry);
        bind += unlessLeftOut(i, fmt::format("    if (shape == {}) {}bind(base);\n", i, tag));
        call += unlessLeftOut(i, fmt::format("    if (shape == {}) return {};\n", i, value));
    }
    text += "void bindField(int shape, int base) {\n    snippetTime = frame.shading.x;\n" + bind +
            "}\n";
    text += "vec2 evaluateField(int shape, vec3 p) {\n    snippetLoops = 0;\n" + call +
            "    return vec2(1.0e9, 0.0);\n}\n";
    out.includes["generated/field.glsl"] = text;

    text = preamble(materials);
    call.clear();
    for (size_t i = 0; i < materials.size(); ++i) {
        const std::string tag = fmt::format("m{}", i);
        text += emit(materials[i], tag, out);
        call +=
            fmt::format("    if (number == {}) {{\n        {}bind(base);\n        {}(s);\n    }}\n",
                        i + 1, tag, emittedName(tag + "_", materials[i]->entry));
    }
    text +=
        "void evaluateMaterial(int number, inout Surface s, int base) {\n    snippetTime = "
        "frame.shading.x;\n    snippetLoops = 0;\n" +
        call + "}\n";
    out.includes["generated/material.glsl"] = text;
    return out;
}

}  // namespace vitrine
