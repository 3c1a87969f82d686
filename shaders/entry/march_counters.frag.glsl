// SPDX-License-Identifier: MIT
#include "pass/march.glsl"

flat in int instance;
layout(location = 0) out vec4 outCounters;

void main() {
    marchPass(ivec2(gl_FragCoord.xy), pixelRay(ivec2(gl_FragCoord.xy)), instance);
    outCounters = marchCounters();
}
