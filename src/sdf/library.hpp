// SPDX-License-Identifier: MIT
// The functions of shaders/lib/sdf and shaders/lib/material, which any snippet may call by name. A
// function's comment holds what is claimed of it, in lines of their own, and the tests, docs/sdf.md
// and docs/patterns.md read the claims there:
//
//   // A torus around the y axis; `ring` is the radius of the circle in its middle.
//   // Source: the distance in the half plane through the axis, where the torus is a disc.
//   // exact                                  or: exact inside, exact outside, bound; or nothing
//   // lipschitz[1.0]                         largest slope; an expression if arguments decide
//   // bounds[-r, -r, -r, r, r, r]            what the shape fills
//   // example[sdTorus(p, 0.6, 0.2)]          a distance to show and to test; there may be several
//   float sdTorus(vec3 p, float ring, float tube) { ... }
//
// Those for materials have, instead of distances,
//
//   // pattern[vec3(patWave(p.x, w.x))]       a colour to show and to test, by the place p, the normal
//                                             n, the pixel's widths w (all in the object's space),
//                                             the curvature k (1/m) and its radius r
//   // shape[sdSphere(p, 1.0)]                what to show it on; a box with round edges if not said
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
/// Those of shaders/lib/material.
const std::vector<EmbeddedFile>& materialLibraryFiles();

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
    /// Of a function for materials: colours to show, and what on ("" if not said).
    std::vector<std::string> patterns;
    std::string shape;

    /// The definition. Of all roles only kText, kName and kGuard occur.
    std::vector<SnippetPiece> pieces;
    /// What it calls of the library: indices of functions that stand before it.
    std::vector<size_t> calls;
};

class Library {
  public:
    /// Reads files, those for materials last; a function may call those of the files before its
    /// own. Throws std::logic_error if anything is wrong with one: the library is part of the
    /// program.
    explicit Library(const std::vector<EmbeddedFile>& fields,
                     const std::vector<EmbeddedFile>& materials = {});

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
    void read(const std::string& folder, const EmbeddedFile& file);

    std::vector<LibraryFunction> functions_;
};

/// The library that snippets see.
const Library& sdfLibrary();

}  // namespace vitrine
