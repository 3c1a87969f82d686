// SPDX-License-Identifier: MIT
#include "pass/view.glsl"

layout(location = 0) out vec4 outRadiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outRadiance = viewPass(pixel);
}
