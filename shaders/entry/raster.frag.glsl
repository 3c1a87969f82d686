// SPDX-License-Identifier: MIT
#include "pass/raster.glsl"

in vec2 barycentrics;
flat in int triangle;
layout(location = 0) out uvec4 outRecord;

void main() {
    outRecord = rasterRecord(gl_FragCoord.xy, triangle, barycentrics, 1.0 / gl_FragCoord.w);
#if HAS_FILTERS
    if (rasterPasses(ivec2(gl_FragCoord.xy), outRecord)) discard;
#endif
}
