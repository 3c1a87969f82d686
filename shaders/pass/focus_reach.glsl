// SPDX-License-Identifier: MIT
// The second step of the lens filter: which bands (shade/circles.glsl) may reach a tile of the picture.
#include "shade/circles.glsl"

uniform sampler2D extents;

vec4 focusReachPass(ivec2 tile) {
    int last = levelOfBand(kBands - 1);
    int around = int(kMostRadius) / kTile + 1;
    int side = 2 * around + 1;
    int bands = 0;
    for (int i = 0; i < side * side; i++) {
        if (!mayLoop()) break;
        ivec2 offset = ivec2(i % side, i / side) - around;
        ivec2 other = tile + offset;
        if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, levelSize(last)))) continue;
        int there = int(texelFetch(extents, levelCorner(last) + other, 0).y);
        float gap = float(kTile * (max(abs(offset.x), abs(offset.y)) - 1));
        for (int band = 0; band < kBands; band++) {
            if (!mayLoop()) break;
            if (gap <= radiusOfBand(band)) bands |= there & (1 << band);
        }
    }
    return vec4(float(bands), 0.0, 0.0, 0.0);
}
