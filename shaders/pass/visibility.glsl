// SPDX-License-Identifier: MIT
// What the camera sees: the closest hit of the camera ray. The `trace` finder.
#define TRACE_ANY 0
#include "trace/trace.glsl"
#include "shade/path.glsl"
#include "shade/counters.glsl"

uvec4 visibilityPass(ivec2 pixel) {
#if HAS_FILTERS
    filterPixel = pixel;
#endif
    return trace(pixelRay(pixel), kInfinity);
}

#if COUNTERS
uvec4 visibilityCounters(ivec2 pixel) { return addCounters(uvec4(0u), 0u); }
#endif
