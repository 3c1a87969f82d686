// SPDX-License-Identifier: MIT
// Radiance that comes from outside the scene.
#include "scene/frame.glsl"

vec3 environmentRadiance(vec3 direction) {
    float up = direction.y;
    vec3 above = mix(frame.background[1].rgb, frame.background[0].rgb, smoothstep(0.0, 1.0, up));
    return mix(above, frame.background[2].rgb, smoothstep(0.0, 0.04, -up));
}
