// SPDX-License-Identifier: MIT
// The bricks of fields/patterns-wall.sdf.glsl: each fired a little differently.
uniform vec2 brick;   // slider[(0.1, 0.04), (0.25, 0.085), (0.5, 0.3)] A brick with its joint, m
uniform float joint;  // slider[0.008, 0.012, 0.03] Width of the joints, m

void material(inout Surface s) {
    vec3 p = s.localPosition;
    vec4 one = patBricks(p.xy, brick, joint, s.localFootprint.xy);
    vec3 fired = noiseHash(vec3(one.yz, 0.0));
    vec3 clay = mix(vec3(0.27, 0.072, 0.045), vec3(0.42, 0.155, 0.085), fired.x);
    clay = mix(clay, vec3(0.085, 0.045, 0.045), step(0.86, fired.y));
    float grain = patNoise(38.0 * p, 3, 0.6, 38.0 * s.footprint);
    float stain = patNoise(2.2 * p, 3, 0.55, 2.2 * s.footprint);
    clay *= 1.0 + 0.28 * grain + 0.30 * stain;
    vec3 mortar = vec3(0.36, 0.34, 0.30) * (1.0 + 0.25 * grain);
    s.baseColor = mix(clay, mortar, one.x);
    s.roughness = 0.85;
    s.specular = 0.5;
}
