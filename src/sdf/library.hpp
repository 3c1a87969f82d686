// SPDX-License-Identifier: MIT
// The functions of shaders/lib/sdf, which any snippet may call by name. A function's comment holds
// what is claimed of it, in lines of their own, and the tests and docs/sdf.md read the claims
// there:
//
//   // A torus around the y axis; `ring` is the radius of the circle in its middle.
//   // Source: the distance in the half plane through the axis, where the torus is a disc.
//   // exact                                  or: exact inside, exact outside, bound; or nothing
//   // lipschitz[1.0]                         largest slope; an expression if arguments decide
//   // bounds[-r, -r, -r, r, r, r]            what the shape fills
//   // example[sdTorus(p, 0.6, 0.2)]          a distance to show and to test; there may be several
//   float sdTorus(vec3 p, float ring, float tube) { ... }
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/embedded_file.hpp"
#include "sdf/snippet.hpp"

namespace vitrine {

/// The files of shaders/lib/sdf in the order of their names. Generated at build time.
const std::vector<EmbeddedFile>& libraryFiles();

struct LibraryFunction {
    /// "As far as the operands" where there are any.
    enum class Quality { kNone, kBound, kExactInside, kExactOutside, kExact };

    std::string name;
    /// "float sdTorus(vec3 p, float ring, float tube)"
    std::string signature;
    size_t argumentCount = 0;
    SourceLocation where;

    std::string about, source;
    Quality quality = Quality::kNone;
    /// What stands in the brackets; empty if nothing is claimed.
    std::string lipschitz, bounds;
    std::vector<std::string> examples;

    /// The definition. Of all roles only kText, kName and kGuard occur.
    std::vector<SnippetPiece> pieces;
    /// What it calls of the library: indices of functions that stand before it.
    std::vector<size_t> calls;
};

class Library {
  public:
    /// Reads files; a function may call those of the files before its own. Throws std::logic_error
    /// if anything is wrong with one: the library is part of the program.
    explicit Library(const std::vector<EmbeddedFile>& files);

    [[nodiscard]] const std::vector<LibraryFunction>& functions() const { return functions_; }
    /// Null if there is none of that name. There are no overloads.
    [[nodiscard]] const LibraryFunction* find(std::string_view name) const;
    /// What the name that other collections use for a function would be here; "" if not known.
    static std::string_view nameHere(std::string_view name);

    /// GLSL of the functions named and of what they call, each behind an #ifndef, so that texts for
    /// several parts of one program can overlap. `loopGuard` as in EmitOptions.
    [[nodiscard]] std::string emit(const std::set<std::string>& names,
                                   const std::string& loopGuard) const;

  private:
    void read(const EmbeddedFile& file);

    std::vector<LibraryFunction> functions_;
};

/// The library that snippets see.
const Library& sdfLibrary();

}  // namespace vitrine
