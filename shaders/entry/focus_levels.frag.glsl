// SPDX-License-Identifier: MIT
#include "pass/focus_levels.glsl"

layout(location = 0) out vec4 outLevels;
layout(location = 1) out vec4 outExtents;

void main() {
    FocusLevels levels = focusLevelsPass(ivec2(gl_FragCoord.xy));
    outLevels = levels.light;
    outExtents = levels.extent;
}
