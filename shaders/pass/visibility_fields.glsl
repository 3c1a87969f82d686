// SPDX-License-Identifier: MIT
// After the rasteriser has found the meshes: the fields in front of them, by tracing.
#define TRACE_ANY 0
#include "trace/trace.glsl"
#include "shade/path.glsl"
#include "shade/counters.glsl"

uvec4 visibilityFieldsPass(ivec2 pixel) {
#if HAS_FILTERS
    filterPixel = pixel;
#endif
    uvec4 mesh = texelFetch(records, pixel, 0);
    float nearest = isSurface(mesh) ? recordDistance(mesh) : kInfinity;
    uvec4 field = trace(pixelRay(pixel), nearest);
    return isSurface(field) ? field : mesh;
}

#if COUNTERS
uvec4 visibilityFieldsCounters(ivec2 pixel) { return addCounters(uvec4(0u), 0u); }
#endif
