// SPDX-License-Identifier: MIT
#include "pass/display.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) uniform writeonly image2D outColor;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.image.xy))) return;
    imageStore(outColor, pixel, displayPass(pixel));
}
