// SPDX-License-Identifier: MIT
#include "pass/bounce.glsl"

layout(location = 0) out uvec4 outRecord;
layout(location = 1) out vec4 outOrigin;
layout(location = 2) out vec4 outDirection;
layout(location = 3) out vec4 outThroughput;
#if COUNTERS
layout(location = 4) out uvec4 outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Bounce bounce = bouncePass(pixel);
    outRecord = bounce.record;
    outOrigin = bounce.origin;
    outDirection = bounce.direction;
    outThroughput = bounce.throughput;
#if COUNTERS
    outCounters = bounceCounters(pixel);
#endif
}
