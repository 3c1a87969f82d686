// SPDX-License-Identifier: MIT
#include "sdf/library.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace vitrine {

namespace {

// Names that people bring along, and where the same thing is found here.
constexpr std::array<std::pair<std::string_view, std::string_view>, 47> kElsewhere = {{
    {"smin", "opSmoothUnion"},
    {"smax", "opSmoothIntersection"},
    {"sminCubic", "opSmoothUnionCubic"},
    {"sminExp", "opSmoothUnionExponential"},
    {"opU", "opUnion"},
    {"opI", "opIntersection"},
    {"opS", "opDifference"},
    {"opSubtraction", "opDifference"},
    {"opSmoothSubtraction", "opSmoothDifference"},
    {"opOnion", "opShell"},
    {"opExtrusion", "opExtrude"},
    {"opRevolution", "domRevolve"},
    {"opRep", "domRepeat"},
    {"opRepetition", "domRepeat"},
    {"opLimitedRepetition", "domRepeatLimited"},
    {"opTwist", "domTwist"},
    {"opCheapBend", "domBend"},
    {"opElongate", "domElongate"},
    {"opSymX", "domMirror"},
    {"pModPolar", "domRepeatPolar"},
    {"pMod1", "domRepeat"},
    {"pMirror", "domMirror"},
    {"fSphere", "sdSphere"},
    {"fBox", "sdBox"},
    {"fPlane", "sdPlane"},
    {"fTorus", "sdTorus"},
    {"fCapsule", "sdCapsule"},
    {"fCylinder", "sdCylinder"},
    {"fCone", "sdCone"},
    {"fDisc", "sdDisc"},
    {"fOpUnionRound", "opRoundUnion"},
    {"fOpUnionChamfer", "opChamferUnion"},
    {"fOpUnionStairs", "opStairsUnion"},
    {"fOpUnionColumns", "opColumnsUnion"},
    {"fOpPipe", "opPipe"},
    {"fOpEngrave", "opEngrave"},
    {"fOpGroove", "opGroove"},
    {"fOpTongue", "opTongue"},
    {"sdRoundBox", "sdRoundedBox"},
    {"fbm", "noiseFbm"},
    {"checker", "patChecker"},
    {"checkers", "patChecker"},
    {"checkersGradBox", "patChecker"},
    {"bricks", "patBricks"},
    {"stripes", "patStripes"},
    {"voronoi", "patCells"},
    {"triplanar", "uvTriplanar"},
}};

std::string textOf(const LibraryFunction& function, const std::string& loopGuard) {
    std::string text;
    int line = function.pieces.front().line;
    for (const SnippetPiece& piece : function.pieces) {
        if (piece.line > line)
            text += '\n';
        else if (piece.spaceBefore && !text.empty())
            text += ' ';
        line = piece.line;
        text += piece.role == SnippetPiece::Role::kGuard ? loopGuard : piece.text;
    }
    return text + '\n';
}

}  // namespace

Library::Library(const std::vector<EmbeddedFile>& fields,
                 const std::vector<EmbeddedFile>& materials) {
    for (const EmbeddedFile& file : fields) read("lib/sdf/", file);
    for (const EmbeddedFile& file : materials) read("lib/material/", file);
}

const LibraryFunction* Library::find(std::string_view name) const {
    const auto found = std::find_if(functions_.begin(), functions_.end(),
                                    [&](const LibraryFunction& f) { return f.name == name; });
    return found == functions_.end() ? nullptr : &*found;
}

std::string_view Library::nameHere(std::string_view name) {
    for (const auto& [elsewhere, here] : kElsewhere)
        if (elsewhere == name) return here;
    return {};
}

std::string Library::emit(const std::set<std::string>& names, const std::string& loopGuard) const {
    // Backwards: whoever is called stands before its callers.
    std::vector<bool> wanted(functions_.size());
    for (size_t i = functions_.size(); i-- > 0;) {
        if (names.contains(functions_[i].name)) wanted[i] = true;
        if (!wanted[i]) continue;
        for (const size_t callee : functions_[i].calls) wanted[callee] = true;
    }
    std::string text;
    for (size_t i = 0; i < functions_.size(); ++i) {
        if (!wanted[i]) continue;
        const std::string guard = "LIBRARY_" + functions_[i].name;
        text += "#ifndef " + guard + "\n#define " + guard + "\n";
        text += textOf(functions_[i], loopGuard) + "#endif\n";
    }
    return text;
}

const Library& sdfLibrary() {
    static const Library library(libraryFiles(), materialLibraryFiles());
    return library;
}

}  // namespace vitrine
