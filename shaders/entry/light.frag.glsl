// SPDX-License-Identifier: MIT
#include "pass/light.glsl"

layout(location = 0) out vec4 outRadiance;
#if COUNTERS
layout(location = 1) out uvec4 outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outRadiance = lightPass(pixel);
#if COUNTERS
    outCounters = lightCounters(pixel);
#endif
}
