// SPDX-License-Identifier: MIT
// Paint on steel: worn off where edges stick out, rust and dirt where they go in, and a warning in
// stripes along one belt.
uniform vec3 paint;  // color[0.035, 0.17, 0.19] Paint
uniform float wear;  // slider[0.0, 0.52, 1.0] How far it has gone

void material(inout Surface s) {
    vec3 p = s.localPosition;
    vec2 at = uvBox(p, s.localNormal);
    vec2 width = abs(uvBox(s.localFootprint, s.localNormal));
    float fine = patNoise(45.0 * p, 3, 0.6, 45.0 * s.footprint);
    float broad = patNoise(6.0 * p, 3, 0.6, 6.0 * s.footprint);
    // A belt of stripes, on the panels of the four sides.
    float stripes = patStripes(9.0 * (at.x + at.y), 0.5, 9.0 * (width.x + width.y));
    float belt = abs(s.localNormal.y) < 0.5 && abs(at.y) < 0.085 && abs(at.x) < 0.3 ? 1.0 : 0.0;
    vec3 color = mix(paint * (1.0 + 0.25 * broad),
                     mix(vec3(0.02), vec3(0.75, 0.42, 0.03), stripes), belt);
    float bare = patWorn(s.curvature, s.curvatureRadius, wear, 0.28 * fine + 0.30 * broad);
    float groove = patWorn(-s.curvature, s.curvatureRadius, 0.75, 0.25 * fine);
    float rust = smoothstep(0.15, 0.6, broad + 0.5 * fine) * bare;
    s.baseColor = mix(color, mix(vec3(0.56, 0.55, 0.53), vec3(0.20, 0.07, 0.025), rust), bare);
    s.metallic = bare * (1.0 - rust);
    s.roughness = mix(0.38 + 0.1 * broad, mix(0.40 + 0.12 * fine, 0.9, rust), bare);
    s.baseColor = mix(s.baseColor, vec3(0.05, 0.035, 0.025), 0.8 * groove);
    s.roughness = mix(s.roughness, 0.95, groove);
}
