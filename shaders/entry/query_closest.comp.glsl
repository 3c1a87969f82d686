// SPDX-License-Identifier: MIT
#define TRACE_ANY 0
#include "pass/query.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32ui) uniform writeonly uimage2D outRecord;
#if COUNTERS
layout(rgba32ui) uniform writeonly uimage2D outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.image.xy))) return;
    imageStore(outRecord, pixel, queryPass(pixel));
#if COUNTERS
    imageStore(outCounters, pixel, queryCounters(pixel));
#endif
}
