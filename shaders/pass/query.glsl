// SPDX-License-Identifier: MIT
// Traces rays that are given as images: for picking, tests and benchmarks.
// TRACE_ANY says which question is asked; entry/query_closest and entry/query_any set it.
#include "trace/trace.glsl"
#include "shade/counters.glsl"

uniform sampler2D rayOrigins;     // xyz: origin, m; w: radius of the cone there
uniform sampler2D rayDirections;  // xyz: unit; w: length

uvec4 queryPass(ivec2 pixel) {
    vec4 origin = texelFetch(rayOrigins, pixel, 0);
    vec4 direction = texelFetch(rayDirections, pixel, 0);
    return trace(Ray(origin.xyz, direction.xyz, origin.w), direction.w);
}

#if COUNTERS
uvec4 queryCounters(ivec2 pixel) { return addCounters(uvec4(0u), 0u); }
#endif
