// SPDX-License-Identifier: MIT
#include "pass/focus_levels.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D outLevels;
layout(rgba32f) uniform writeonly image2D outExtents;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(outLevels)))) return;
    FocusLevels levels = focusLevelsPass(texel);
    imageStore(outLevels, texel, levels.light);
    imageStore(outExtents, texel, levels.extent);
}
