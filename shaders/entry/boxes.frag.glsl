// SPDX-License-Identifier: MIT
#include "pass/boxes.glsl"

in vec4 line;
flat in ivec2 drawn;
layout(location = 0) out vec4 outColor;

void main() {
    outColor = boxColor(gl_FragCoord.xy, line, drawn);
}
