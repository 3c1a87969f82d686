// SPDX-License-Identifier: MIT
#include "pass/accumulate.glsl"

layout(location = 0) out vec4 outMean;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outMean = accumulatePass(pixel);
}
