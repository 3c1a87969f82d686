// SPDX-License-Identifier: MIT
#include "pass/visibility.glsl"

layout(location = 0) out uvec4 outRecord;
#if COUNTERS
layout(location = 1) out uvec4 outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outRecord = visibilityPass(pixel);
#if COUNTERS
    outCounters = visibilityCounters(pixel);
#endif
}
