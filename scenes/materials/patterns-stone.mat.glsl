// SPDX-License-Identifier: MIT
// Crazy paving on any shape: cells of a plane, laid on from three sides. The loop writes the pattern
// once; a bump from the same cells is what their borders give.
uniform float size;  // slider[0.02, 0.11, 0.5] Width of a stone, m

void material(inout Surface s) {
    vec3 share = uvTriplanar(s.localNormal, 9.0);
    float joint = 0.0;
    float tone = 0.0;
    for (int i = 0; i < 3; i++) {
        vec4 cell = patCells(vec3(uvPlane(s.localPosition, i) / size, 0.5 + 7.0 * float(i)));
        float wide = s.footprint / size;
        joint += share[i] * smoothstep(0.13 + wide, 0.05 - wide, cell.y - cell.x);
        tone += share[i] * cell.z;
    }
    float grain = patNoise(24.0 * s.localPosition, 4, 0.6, 24.0 * s.footprint);
    vec3 stone = mix(vec3(0.20, 0.185, 0.16), vec3(0.46, 0.42, 0.35), tone) * (1.0 + 0.35 * grain);
    vec3 moss = vec3(0.07, 0.085, 0.03) * (1.0 + 0.5 * grain);
    s.baseColor = mix(stone, moss, joint);
    s.roughness = mix(0.55, 1.0, joint);
}
