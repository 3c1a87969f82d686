// SPDX-License-Identifier: MIT
// For the tests of this folder only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sdf/emit.hpp"
#include "sdf/snippet.hpp"

namespace vitrine {

/// All diagnostics of a source, one a line, without the file name: "3:7: error: ...".
inline std::string problemsOf(std::string_view source, SnippetKind kind = SnippetKind::kField) {
    Diagnostics diagnostics;
    const bool read = parseSnippet(source, "t", kind, diagnostics).has_value();
    std::string text = diagnostics.text();
    if (read == diagnostics.hasErrors()) text += "\nthe result contradicts the messages";
    std::string result;
    for (size_t i = 0; i < text.size(); ++i) {
        const bool lineStart = i == 0 || text[i - 1] == '\n';
        if (lineStart && text.compare(i, 2, "t:") == 0) i += 2;
        result += text[i];
    }
    return result;
}

/// A snippet that has to be good.
inline Snippet good(std::string_view source, SnippetKind kind = SnippetKind::kField) {
    Diagnostics diagnostics;
    std::optional<Snippet> snippet = parseSnippet(source, "t", kind, diagnostics);
    return snippet ? *snippet : throw InputError(diagnostics);
}

/// Short names, so that expected texts can be read.
inline EmitOptions shortOptions() {
    EmitOptions options;
    options.prefix = "X_";
    options.lineBase = 1000;
    options.parameter = [](const Parameter& p, int index) {
        return "P" + std::to_string(index) + (componentCount(p.type) == 3 ? ".xyz" : "");
    };
    options.builtins = {{"time", "T"}, {"resolution", "R"}};
    options.loopGuard = "G()";
    return options;
}

inline std::string emitted(std::string_view source, SnippetKind kind = SnippetKind::kField) {
    return emitSnippet(good(source, kind), shortOptions());
}

/// The emitted text of one line of `source`, or of the statements in a field's body.
inline std::string emittedBody(const std::string& body) {
    const std::string head = "float sdf(vec3 p){\n";
    const std::string text = emitted("uniform float r; // slider[0,1,2]\n" + head + body + "\n}\n");
    const size_t start = text.find('{') + 2;
    return text.substr(start, text.rfind('}') - start - 1);
}

}  // namespace vitrine
