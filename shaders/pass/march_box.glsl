// SPDX-License-Identifier: MIT
// Corners of the boxes that the `march` finder draws, many in one call.
#include "shared/limits.glsl"

uniform mat4 clipFromBox[VITRINE_BOXES_A_DRAW];
uniform int boxInstance[VITRINE_BOXES_A_DRAW];

// A cube from -1 to 1 as a strip of 14 vertices, in clip space. Each bit of the three numbers says
// on which side of its axis a vertex lies.
vec4 boxVertex(int box, int vertex) {
    ivec3 side = (ivec3(0x287a, 0x02af, 0x31e3) >> vertex) & 1;
    return clipFromBox[box] * vec4(vec3(2 * side - 1), 1.0);
}
