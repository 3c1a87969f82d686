// SPDX-License-Identifier: MIT
// Radiance that comes from outside the scene.
#include "scene/frame.glsl"

vec3 environmentRadiance(vec3 direction) {
    float up = direction.y;
    // Square root: skies change fastest near the horizon.
    vec3 above = mix(frame.background[1].rgb, frame.background[0].rgb, sqrt(max(up, 0.0)));
    return mix(above, frame.background[2].rgb, smoothstep(0.0, 0.04, -up));
}
