// SPDX-License-Identifier: MIT
// What the kinds of snippets differ in: one row of a table each. A new kind is a new row.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sdf/problems.hpp"
#include "sdf/snippet.hpp"

namespace vitrine::glsl {

struct Argument {
    std::string type;
    /// "in", "out" or "inout".
    std::string direction = "in";
    friend bool operator==(const Argument&, const Argument&) = default;
};

/// A function of the snippet, all its prototypes and its definition taken together.
struct Function {
    std::string name;
    std::string returnType;
    std::vector<Argument> arguments;
    Place place;
    bool defined = false;
    struct Call {
        size_t callee = 0;
        Place place;
    };
    std::vector<Call> calls;
    /// Functions of the library that it calls, each once.
    std::set<std::string> libraryCalls;
    /// Its definition in Snippet::pieces: [firstPiece, lastPiece).
    size_t firstPiece = 0, lastPiece = 0;
};

/// A variable that the renderer provides.
struct Builtin {
    std::string_view name;
    /// Into EmitOptions::builtins.
    std::string_view key;
    std::string_view type;
    /// Which components of that value it is, as ".xy".
    std::string_view components;
};

/// Null if `name` is not built in for this kind.
const Builtin* findBuiltin(SnippetKind kind, std::string_view name);

/// Of all that findBuiltin finds.
std::vector<std::string> builtinNames(SnippetKind kind);

/// Finds the function to be called and writes it into `snippet`; reports if there is none.
void chooseEntry(std::span<const Function> functions, Snippet& snippet, Problems& problems);

}  // namespace vitrine::glsl
