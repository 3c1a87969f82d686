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
    vec3 axis = fetchTable(i + 2).xyz;
    vec2 cosines = fetchTable(i + 3).xy;
    int type = int(a.w);
    if (type == VITRINE_LIGHT_SUN) return LightSample(-axis, kInfinity, b.rgb);
    vec3 way = a.xyz - position;
    float distanceSquared = max(dot(way, way), 1.0e-8);
    float distance = sqrt(distanceSquared);
    vec3 direction = way / distance;
    // The window of KHR_lights_punctual, which takes a light to nothing at its range.
    float q = b.w > 0.0 ? distance / b.w : 0.0;
    float window = clamp(1.0 - q * q * q * q, 0.0, 1.0);
    float cone = 1.0;
    if (type == VITRINE_LIGHT_SPOT)
        cone = clamp((dot(axis, -direction) - cosines.y) / max(cosines.x - cosines.y, 1.0e-3), 0.0,
                     1.0);
    return LightSample(direction, distance * 0.99999,
                       b.rgb * window * cone * cone / distanceSquared);
}
