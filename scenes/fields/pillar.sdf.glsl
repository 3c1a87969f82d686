// SPDX-License-Identifier: MIT
// A round pillar that stands on the origin, and a ball on top of it.
// bounds[-0.45, -0.02, -0.45,  0.45, 2.85, 0.45]
// parts[pillar, ball]
uniform float height;  // slider[0.1, 1.2, 2.0] Of the pillar, m
uniform float radius;  // slider[0.1, 0.3, 0.42] Of the pillar, m
uniform float ball;    // slider[0.05, 0.25, 0.40] Radius of the ball, m

vec2 sdf(vec3 p) {
    float pillar = sdRoundedCylinder(p - vec3(0.0, 0.5 * height, 0.0), radius, 0.5 * height, 0.03);
    float onTop = length(p - vec3(0.0, height + ball, 0.0)) - ball;
    return onTop < pillar ? vec2(onTop, 1.0) : vec2(pillar, 0.0);
}
