// SPDX-License-Identifier: MIT
#include "pass/focus_reach.glsl"

layout(location = 0) out vec4 outReach;

void main() { outReach = focusReachPass(ivec2(gl_FragCoord.xy)); }
