// SPDX-License-Identifier: MIT
// How much of the light from one direction the lobes send back in all directions, from the table of
// pack/albedo_table.hpp.
#include "scene/fetch.glsl"

// x, y: the GGX lobe, parts that f0 and f90 multiply; z: the sheen lobe.
vec3 directionalAlbedo(float cosine, float roughness) {
    vec2 nodes = vec2(VITRINE_ALBEDO_COSINES - 1, VITRINE_ALBEDO_ROUGHNESSES - 1);
    vec2 p = clamp(vec2(cosine, roughness), 0.0, 1.0) * nodes;
    vec2 low = min(floor(p), nodes - 1.0);
    vec2 part = p - low;
    int at = frame.path.w + int(low.y) * VITRINE_ALBEDO_COSINES + int(low.x);
    vec3 smoother = mix(fetchTable(at).xyz, fetchTable(at + 1).xyz, part.x);
    vec3 rougher = mix(fetchTable(at + VITRINE_ALBEDO_COSINES).xyz,
                       fetchTable(at + VITRINE_ALBEDO_COSINES + 1).xyz, part.x);
    return mix(smoother, rougher, part.y);
}
