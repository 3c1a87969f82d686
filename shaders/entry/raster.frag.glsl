// SPDX-License-Identifier: MIT
#include "pass/raster.glsl"

in vec2 barycentrics;
flat in int triangle;
layout(location = 0) out uvec4 outRecord;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outRecord = rasterRecord(pixel, triangle, barycentrics, 1.0 / gl_FragCoord.w);
#if HAS_FILTERS
    if (rasterPasses(pixel, outRecord)) discard;
#endif
}
