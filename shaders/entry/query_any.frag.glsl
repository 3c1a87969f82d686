// SPDX-License-Identifier: MIT
#define TRACE_ANY 1
#include "pass/query.glsl"

layout(location = 0) out uvec4 outRecord;
#if COUNTERS
layout(location = 1) out uvec4 outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outRecord = queryPass(pixel);
#if COUNTERS
    outCounters = queryCounters(pixel);
#endif
}
