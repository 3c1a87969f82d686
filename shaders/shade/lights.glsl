// SPDX-License-Identifier: MIT
// Lights as a point sees them.
#include "scene/fetch.glsl"

struct LightSample {
    vec3 direction;   // towards the light, unit
    float distance;   // free way that a shadow ray needs
    vec3 irradiance;  // on a surface that faces the light
};

LightSample sampleLight(int light, vec3 position) {
    int i = frame.tables.z + light * VITRINE_LIGHT_TEXELS;
    vec4 a = fetchTable(i);
    vec4 b = fetchTable(i + 1);
    if (int(a.w) == VITRINE_LIGHT_SUN) return LightSample(-a.xyz, kInfinity, b.rgb);
    vec3 way = a.xyz - position;
    float distanceSquared = max(dot(way, way), 1.0e-8);
    float distance = sqrt(distanceSquared);
    return LightSample(way / distance, distance * 0.99999, b.rgb / distanceSquared);
}
