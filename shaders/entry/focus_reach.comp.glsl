// SPDX-License-Identifier: MIT
#include "pass/focus_reach.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D outReach;

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile, levelSize(levelOfBand(kBands - 1))))) return;
    imageStore(outReach, tile, focusReachPass(tile));
}
