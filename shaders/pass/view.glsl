// SPDX-License-Identifier: MIT
// Every stage made visible: what the records say, and what the counters counted.
#include "shade/path.glsl"
#include "shade/surface.glsl"

uniform usampler2D counters;

// Heat on a logarithmic scale: 1 is black, `full` is white.
vec3 heatOfCount(uint count, float full) { return heat(log2(1.0 + float(count)) / log2(1.0 + full)); }

vec4 viewPass(ivec2 pixel) {
    int view = frame.image.w;
    uvec4 counted = texelFetch(counters, pixel, 0);
    if (view == VITRINE_VIEW_LOOPS) return vec4(heatOfCount(counted.x, 16384.0), 1.0);
    if (view == VITRINE_VIEW_NODES) return vec4(heatOfCount(counted.y, 1024.0), 1.0);
    if (view == VITRINE_VIEW_STEPS) return vec4(heatOfCount(counted.z, 1024.0), 1.0);

    uvec4 record = texelFetch(records, pixel, 0);
    if (!isSurface(record)) return vec4(0.0, 0.0, 0.0, 1.0);
    Hit hit = loadHit(record, pixelRay(pixel));
    vec3 c = vec3(0.0);
    if (view == VITRINE_VIEW_ALBEDO) c = hit.surface.baseColor;
    if (view == VITRINE_VIEW_NORMAL) c = 0.5 + 0.5 * hit.surface.normal;
    if (view == VITRINE_VIEW_DEPTH) c = vec3(exp(-recordDistance(record) / frame.display.z));
    if (view == VITRINE_VIEW_INSTANCE) c = colorOfId(record.x);
    if (view == VITRINE_VIEW_PRIMITIVE) c = colorOfId(numberOf(record));
    if (view == VITRINE_VIEW_MATERIAL) c = colorOfId(uint(hit.material));
    if (view == VITRINE_VIEW_BARYCENTRIC) {
        vec2 b = unpackBarycentrics(record.z);
        if (fetchInstance(int(record.x)).kind == VITRINE_KIND_MESH) c = vec3(1.0 - b.x - b.y, b.x, b.y);
    }
    return vec4(c, 1.0);
}
