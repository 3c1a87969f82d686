// SPDX-License-Identifier: MIT
#include "pass/display.glsl"

layout(location = 0) out vec4 outColor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outColor = displayPass(pixel);
}
