// SPDX-License-Identifier: MIT
#include "pass/march_box.glsl"

flat out int instance;

void main() {
    gl_Position = boxVertex(gl_InstanceID, gl_VertexID);
    instance = boxInstance[gl_InstanceID];
}
