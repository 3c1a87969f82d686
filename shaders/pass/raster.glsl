// SPDX-License-Identifier: MIT
// The `raster` finder: triangles into records. The thin G-buffer of visibility-buffer rendering
// (Burns & Hunt 2013): instance, triangle, barycentrics and distance, nothing else.
#include "scene/fetch.glsl"
#include "lib/hit_record.glsl"
#include "shade/path.glsl"
#include "trace/filter.glsl"

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

#if HAS_FILTERS
// Is there a hole, a veil or a back at this hit? Then the rasteriser passes it as a ray does.
bool rasterPasses(ivec2 pixel, uvec4 record) {
    filterPixel = pixel;
    int flags = fetchInstance(drawnInstance).flags;
    bool pending = (flags & VITRINE_INSTANCE_FILTERED) != 0;
    bool passes = false;
    // A loop, because the lanes of a CPU skip nothing else.
    while (pending && mayLoop()) {
        pending = false;
        passes = !stopsRay(loadBarrier(record, cameraRay(pixelPosition(pixel))), record);
    }
    return passes;
}
#endif
