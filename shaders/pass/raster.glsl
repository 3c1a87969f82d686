// SPDX-License-Identifier: MIT
// The `raster` finder: triangles into records. The thin G-buffer of visibility-buffer rendering
// (Burns & Hunt 2013): instance, triangle, barycentrics and distance, nothing else.
#include "scene/fetch.glsl"
#include "lib/hit_record.glsl"
#include "shade/path.glsl"

uniform mat4 clipFromObject;
uniform int drawnInstance;
uniform int firstTriangle;

struct RasterVertex {
    vec4 position;      // clip space
    vec2 barycentrics;  // weights of the second and third corner
    int triangle;
};

RasterVertex rasterVertex(int vertex) {
    int triangle = vertex / 3;
    int corner = vertex - 3 * triangle;
    uvec4 corners = fetchTriangle(firstTriangle + triangle);
    uint index = corner == 0 ? corners.x : corner == 1 ? corners.y : corners.z;
    vec3 position = fetchVertex(int(index)).position;
    return RasterVertex(clipFromObject * vec4(position, 1.0),
                        vec2(corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0), triangle);
}

// `depth`: along the camera's forward direction, m.
uvec4 rasterRecord(ivec2 pixel, int triangle, vec2 barycentrics, float depth) {
    Ray ray = cameraRay(pixelPosition(pixel));
    float t = depth / dot(ray.direction, frame.cameraForward.xyz);
    return packHit(uint(drawnInstance), uint(triangle), packBarycentrics(barycentrics), t);
}
