// SPDX-License-Identifier: MIT
#include "pass/boxes.glsl"

out vec4 line;
flat out ivec2 drawn;

void main() {
    BoxVertex vertex = boxVertex(gl_VertexID);
    gl_Position = vec4(vertex.position, 0.0, 1.0);
    line = vertex.line;
    drawn = vertex.drawn;
}
