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

// `position`: the pixel's centre; `depth`: along the camera's forward direction, m. The distance
// along the ray follows without a direction: the three axes of the camera are square to each other.
uvec4 rasterRecord(vec2 position, int triangle, vec2 barycentrics, float depth) {
    vec2 p = 2.0 * (position + frame.jitter.xy) / vec2(frame.image.xy) - 1.0;
    float t = depth * sqrt(1.0 + p.x * p.x * frame.cameraRight.w + p.y * p.y * frame.cameraUp.w);
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
        passes = !stopsRay(loadBarrier(record, pixelRay(pixel)), record);
    }
    return passes;
}
#endif
