// SPDX-License-Identifier: MIT
#include "pass/visibility_fields.glsl"

layout(location = 0) out uvec4 outRecord;
#if COUNTERS
layout(location = 1) out uvec4 outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outRecord = visibilityFieldsPass(pixel);
#if COUNTERS
    outCounters = visibilityFieldsCounters(pixel);
#endif
}
