// SPDX-License-Identifier: MIT
#include "pass/focus.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D outRadiance;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.image.xy))) return;
    imageStore(outRadiance, pixel, focusPass(pixel));
}
