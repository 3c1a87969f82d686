// SPDX-License-Identifier: MIT
// The library of distance functions as C++ in double precision (library_to_cpp.cpp), for tests.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/math.hpp"

namespace vitrine {

struct Bounds {
    glm::dvec3 low, high;
};

/// An example of a function's comment. 2-D shapes read x and y.
struct Example {
    std::string function, text;
    std::function<double(const glm::dvec3&)> value;
    /// What the comment claims the shape to fill; null where it does not say, or the example is
    /// more than the bare call. The point does not matter.
    std::function<Bounds(const glm::dvec3&)> bounds;
};

/// What a pattern of a function's comment may ask: place, normal and widths of the pixel in the
/// object's space, curvature (1/m) and the radius it is taken over (m).
struct PatternPlace {
    glm::dvec3 p, n, w;
    double k = 0, r = 0;
};

/// A pattern of a function's comment.
struct Pattern {
    std::string function, text;
    std::function<glm::dvec3(const PatternPlace&)> color;
};

namespace library {

// What GLSL has built in, for the generated text.
using namespace glm;
using vec2 = dvec2;
using vec3 = dvec3;
using vec4 = dvec4;

/// How often the loops of the library have gone round so far.
inline int loops = 0;
inline bool loopGuard() {
    ++loops;
    return true;
}

template <int... index, class Vector>
auto swizzle(const Vector& v) {
    return glm::vec<sizeof...(index), double>(v[index]...);
}

inline Bounds makeBounds(vec3 low, vec3 high) {
    return {low, high};
}
inline Bounds makeBounds(vec2 low, vec2 high) {
    return {vec3(low, -1e9), vec3(high, 1e9)};
}

// Bounds do not need every argument, and a local name may hide one of GLSL's functions.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wshadow"
#include "sdf/library_as_cpp.inc"
#pragma GCC diagnostic pop

}  // namespace library
}  // namespace vitrine
