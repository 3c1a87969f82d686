// SPDX-License-Identifier: MIT
// A brick wall with a coping, weathered: the bricks stand out of their mortar by the height that the
// pattern returns, which the material's own call of it colours.
// bounds[-1.95, 0.0, -0.19, 1.95, 1.72, 0.19]
// parts[bricks, coping]
// lipschitz[2.9]
uniform vec2 brick;   // slider[(0.1, 0.04), (0.25, 0.085), (0.5, 0.3)] A brick with its joint, m
uniform float joint;  // slider[0.008, 0.012, 0.03] Width of the joints, m

vec2 sdf(vec3 p) {
    vec3 q = p - vec3(0.0, 0.80, 0.0);
    float wall = sdBox(q, vec3(1.87, 0.80, 0.115));
    vec4 one = patBricks(p.xy, brick, joint, vec2(0.0));
    float chipped = 0.6 + 0.4 * noiseHash(vec3(one.yz, 1.0)).y;
    wall -= 0.010 * one.w * chipped;
    vec3 c = p - vec3(0.0, 1.655, 0.0);
    float slope = 0.25 * abs(c.z);
    float coping = 0.95 * (sdRoundedBox(c + vec3(0.0, slope, 0.0), vec3(1.93, 0.045, 0.17), 0.012));
    return wall < coping ? vec2(wall, 0.0) : vec2(coping, 1.0);
}
