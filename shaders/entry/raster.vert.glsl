// SPDX-License-Identifier: MIT
#include "pass/raster.glsl"

out vec2 barycentrics;
flat out int triangle;

void main() {
    RasterVertex vertex = rasterVertex(gl_VertexID);
    gl_Position = vertex.position;
    barycentrics = vertex.barycentrics;
    triangle = vertex.triangle;
}
