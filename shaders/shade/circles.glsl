// SPDX-License-Identifier: MIT
// Circles of confusion in pixels, and the atlas in which a sharp picture lies ready to be blurred by
// them (pass/focus.glsl).
//
// Pixels are sorted into bands by the radius of their circle. What blurs widely is kept coarsely:
//
//   band 0: up to 1 pixel, 1: up to 6, 2: up to 12, 3: up to 24, 4: up to 48, 5: all above
//   bands 0 and 1 lie in level 0, which is the picture; band k in level k - 1, whose texels stand for
//   2^level pixels along an edge and hold the mean of those of their band, and the share that those are
//
// Level 0 is on the left of the atlas, the others stand on each other on its right.
#include "scene/frame.glsl"

const int kBands = 6;
const int kTile = 16;  // pixels along an edge of a texel of the last level
// A circle that is wider is drawn with this radius.
const float kMostRadius = 128.0;

int levelOfBand(int band) { return max(band - 1, 0); }

float radiusOfBand(int band) {
    return band == 0 ? 1.0 : band == kBands - 1 ? kMostRadius : 3.0 * float(1 << band);
}

int bandOf(float radius) {
    ivec4 above = ivec4(greaterThan(vec4(radius), vec4(1.0, 6.0, 12.0, 24.0)));
    return above.x + above.y + above.z + above.w + (radius > 48.0 ? 1 : 0);
}

ivec2 levelSize(int level) { return (frame.image.xy + (1 << level) - 1) >> level; }

ivec2 levelCorner(int level) {
    if (level == 0) return ivec2(0);
    ivec4 heights = (ivec4(frame.image.y) + ivec4(1, 3, 7, 15)) >> ivec4(1, 2, 3, 4);
    int below = (level > 1 ? heights.x : 0) + (level > 2 ? heights.y : 0) + (level > 3 ? heights.z : 0);
    return ivec2(frame.image.x, below);
}

// Radius of what `depth` metres along the axis becomes through the lens; below 0 in front of what is
// sharp. The formula of packCamera(), which is that of Potmesil & Chakravarty (A Lens and Aperture
// Camera Model for Synthetic Image Generation, SIGGRAPH 1981) for a lens that does not breathe.
float circleRadius(float depth) {
    float atInfinity = frame.lens.w / (frame.lens.y * frame.cameraEye.w);
    return clamp(atInfinity * (1.0 - frame.lens.y / max(depth, 1.0e-6)), -kMostRadius, kMostRadius);
}
