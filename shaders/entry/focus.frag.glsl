// SPDX-License-Identifier: MIT
#include "pass/focus.glsl"

layout(location = 0) out vec4 outRadiance;

void main() { outRadiance = focusPass(ivec2(gl_FragCoord.xy)); }
