// SPDX-License-Identifier: MIT
#include "sdf/words.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"

namespace vitrine::glsl {

namespace {

using Word = std::string_view;

template <size_t n>
bool contains(const std::array<Word, n>& list, Word word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

// The types that GLSL ES 3.00 and GLSL 4.10 share, samplers apart.
constexpr std::array<std::pair<Word, int>, 29> kTypes = {{
    {"void", 1},   {"float", 1},   {"int", 1},    {"uint", 1},    {"bool", 1},    {"vec2", 2},
    {"vec3", 3},   {"vec4", 4},    {"ivec2", 2},  {"ivec3", 3},   {"ivec4", 4},   {"uvec2", 2},
    {"uvec3", 3},  {"uvec4", 4},   {"bvec2", 2},  {"bvec3", 3},   {"bvec4", 4},   {"mat2", 4},
    {"mat3", 9},   {"mat4", 16},   {"mat2x2", 4}, {"mat2x3", 6},  {"mat2x4", 8},  {"mat3x2", 6},
    {"mat3x3", 9}, {"mat3x4", 12}, {"mat4x2", 8}, {"mat4x3", 12}, {"mat4x4", 16},
}};

constexpr std::array<Word, 7> kQualifiers = {"const", "in",      "out", "inout",
                                             "highp", "mediump", "lowp"};

constexpr std::array<Word, 17> kShaderInterface = {
    "uniform",    "attribute", "varying",  "buffer",    "shared",        "layout",
    "flat",       "smooth",    "centroid", "sample",    "noperspective", "patch",
    "subroutine", "coherent",  "readonly", "writeonly", "volatile"};

constexpr std::array<Word, 13> kStatements = {"if",       "else",    "for",      "while",  "do",
                                              "switch",   "case",    "default",  "return", "break",
                                              "continue", "discard", "precision"};

constexpr std::array<Word, 5> kOthers = {"struct", "true", "false", "invariant", "precise"};

constexpr Word kNoDerivatives =
    "derivatives do not exist along a ray: take the difference of two values instead";
constexpr Word kNoDiscard = "a ray asks for a value, there is no pixel to discard";
constexpr Word kNoTextures = "snippets have no textures";

constexpr Word kNotInWebGl = "it does not exist in WebGL2, and a snippet has to run there too";

constexpr std::array<std::pair<Word, Word>, 21> kRefused = {{
    {"fma", kNotInWebGl},
    {"ldexp", kNotInWebGl},
    {"frexp", kNotInWebGl},
    {"bitCount", kNotInWebGl},
    {"findLSB", kNotInWebGl},
    {"findMSB", kNotInWebGl},
    {"bitfieldExtract", kNotInWebGl},
    {"dFdx", kNoDerivatives},
    {"dFdy", kNoDerivatives},
    {"fwidth", kNoDerivatives},
    {"discard", kNoDiscard},
    {"texture", kNoTextures},
    {"texture2D", kNoTextures},
    {"textureLod", kNoTextures},
    {"texelFetch", kNoTextures},
    {"iChannel0", kNoTextures},
    {"iChannel1", kNoTextures},
    {"iChannel2", kNoTextures},
    {"iChannel3", kNoTextures},
    {"iChannelResolution", kNoTextures},
    {"barrier", "a snippet runs for one ray alone"},
}};

}  // namespace

int builtinTypeSize(Word word) {
    for (const auto& [name, size] : kTypes)
        if (name == word) return size;
    return 0;
}

bool isQualifier(Word word) {
    return contains(kQualifiers, word);
}
bool isShaderInterface(Word word) {
    return contains(kShaderInterface, word);
}
bool isStatementWord(Word word) {
    return contains(kStatements, word);
}

bool isReserved(Word word) {
    // "sample", "shared", "buffer" and the like are fine names in GLSL ES 3.00, and get a prefix.
    constexpr std::array<Word, 5> kStorage = {"uniform", "attribute", "varying", "layout", "flat"};
    return builtinTypeSize(word) > 0 || isQualifier(word) || isStatementWord(word) ||
           contains(kOthers, word) || contains(kStorage, word);
}

const std::vector<std::string>& builtinFunctions() {
    static const std::vector<std::string> kFunctions = {"radians",
                                                        "degrees",
                                                        "sin",
                                                        "cos",
                                                        "tan",
                                                        "asin",
                                                        "acos",
                                                        "atan",
                                                        "sinh",
                                                        "cosh",
                                                        "tanh",
                                                        "asinh",
                                                        "acosh",
                                                        "atanh",
                                                        "pow",
                                                        "exp",
                                                        "log",
                                                        "exp2",
                                                        "log2",
                                                        "sqrt",
                                                        "inversesqrt",
                                                        "abs",
                                                        "sign",
                                                        "floor",
                                                        "trunc",
                                                        "round",
                                                        "roundEven",
                                                        "ceil",
                                                        "fract",
                                                        "mod",
                                                        "modf",
                                                        "min",
                                                        "max",
                                                        "clamp",
                                                        "mix",
                                                        "step",
                                                        "smoothstep",
                                                        "isnan",
                                                        "isinf",
                                                        "floatBitsToInt",
                                                        "floatBitsToUint",
                                                        "intBitsToFloat",
                                                        "uintBitsToFloat",
                                                        "packSnorm2x16",
                                                        "unpackSnorm2x16",
                                                        "packUnorm2x16",
                                                        "unpackUnorm2x16",
                                                        "packHalf2x16",
                                                        "unpackHalf2x16",
                                                        "length",
                                                        "distance",
                                                        "dot",
                                                        "cross",
                                                        "normalize",
                                                        "faceforward",
                                                        "reflect",
                                                        "refract",
                                                        "matrixCompMult",
                                                        "outerProduct",
                                                        "transpose",
                                                        "determinant",
                                                        "inverse",
                                                        "lessThan",
                                                        "lessThanEqual",
                                                        "greaterThan",
                                                        "greaterThanEqual",
                                                        "equal",
                                                        "notEqual",
                                                        "any",
                                                        "all",
                                                        "not"};
    return kFunctions;
}

bool isBuiltinFunction(Word word) {
    const auto& list = builtinFunctions();
    return std::find(list.begin(), list.end(), word) != list.end();
}

std::string_view reasonAgainst(Word name) {
    for (const auto& [refused, reason] : kRefused)
        if (refused == name) return reason;
    if (startsWith(name, "gl_")) return "a snippet is called for rays, outside of any shader stage";
    return {};
}

}  // namespace vitrine::glsl
