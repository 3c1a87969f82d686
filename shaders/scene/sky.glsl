// SPDX-License-Identifier: MIT
// The picture of all directions that pack/sky_map.hpp prepares, and directions chosen by its trees.
#include "scene/fetch.glsl"

#if HAS_SKY
uniform sampler2D skyPicture;  // rgb: what is ambient; a: luminance of the rest; / frame.sky.x

vec2 skyCoordinates(vec3 direction) {
    float around = atan(direction.z, direction.x) / (2.0 * kPi);
    return vec2(fract(around + frame.sky.y + 0.5),
                0.5 - asin(clamp(direction.y, -1.0, 1.0)) / kPi);
}

// The level whose texels are as large as a solid angle.
float skyLevel(float solidAngle) {
    return 0.5 * log2(max(solidAngle, 1.0e-12) * square(frame.sky.z / (2.0 * kPi)));
}

vec4 skyTexel(vec3 direction, float level) {
    return frame.sky.x * textureLod(skyPicture, skyCoordinates(direction), max(level, 0.0));
}

const float kBelowOne = 0.99999994;

struct SkySample {
    vec3 direction;
    float density;  // per solid angle
};

// A node's children are cells of equal angles: left and right, upper and lower.
float cellSolidAngle(int row, int rows) {
    float height = kPi / float(rows);
    float middle = (float(row) + 0.5) * height;
    return 2.0 * sin(middle) * sin(0.5 * height) * (kPi / float(rows));
}

// The number of stratified points stays stratified: each step down the tree stretches a part of the
// unit square to the whole (Clarberg et al., Wavelet Importance Sampling, 2005).
SkySample sampleSky(vec2 u) {
    int first = frame.skyTree.x;
    int columns = 1;
    ivec2 cell = ivec2(0);
    float probability = 0.0;
    for (int level = 0; level < frame.skyTree.y; level++) {
        if (!mayLoop()) break;
        vec4 node = FETCH(skyTree, first + cell.y * columns + cell.x);
        float left = node.x + node.z;
        float share = left / max(left + node.y + node.w, 1.0e-37);
        bool right = u.x >= share && node.y + node.w > 0.0;
        u.x = right ? (u.x - share) / (1.0 - share) : min(u.x / share, kBelowOne);
        vec2 column = right ? node.yw : node.xz;
        share = column.x / max(column.x + column.y, 1.0e-37);
        bool lower = u.y >= share && column.y > 0.0;
        u.y = lower ? (u.y - share) / (1.0 - share) : min(u.y / share, kBelowOne);
        probability = lower ? column.y : column.x;
        cell = 2 * cell + ivec2(right ? 1 : 0, lower ? 1 : 0);
        first += level == 0 ? 1 : columns * (columns / 2);
        columns *= 2;
    }
    int rows = columns / 2;
    // Evenly over the solid angle of the cell.
    float above = cos(kPi * float(cell.y) / float(rows));
    float below = cos(kPi * float(cell.y + 1) / float(rows));
    float y = mix(above, below, u.y);
    float around = 2.0 * kPi * ((float(cell.x) + u.x) / float(columns) - frame.sky.y - 0.5);
    float r = sqrt(max(0.0, 1.0 - y * y));
    return SkySample(vec3(r * cos(around), y, r * sin(around)),
                     probability / cellSolidAngle(cell.y, rows));
}

// The density with which sampleSky finds a direction.
float skyDensity(vec3 direction) {
    int columns = 1 << frame.skyTree.y;
    int rows = columns / 2;
    vec2 uv = skyCoordinates(direction);
    ivec2 cell = min(ivec2(uv * vec2(columns, rows)), ivec2(columns, rows) - 1);
    // Nodes of the levels above the last: 1 + 2 + 8 + 32 ...
    int columnsAbove = columns / 2;
    int nodesAbove = frame.skyTree.y == 1 ? 0 : 1 + 2 * ((columnsAbove * columnsAbove / 4 - 1) / 3);
    vec4 node = FETCH(skyTree, frame.skyTree.x + nodesAbove + (cell.y / 2) * columnsAbove + cell.x / 2);
    vec2 column = (cell.x & 1) == 0 ? node.xz : node.yw;
    return ((cell.y & 1) == 0 ? column.x : column.y) / cellSolidAngle(cell.y, rows);
}
#endif
