// SPDX-License-Identifier: MIT
// Turned from a trunk that lay along x, with oil on it.
uniform float rings;  // slider[5.0, 55.0, 200.0] Rings a metre

void material(inout Surface s) {
    vec3 p = s.localPosition.yxz + vec3(0.13, 0.0, 0.21);
    float wide = max(s.localFootprint.y, s.localFootprint.z);
    float ring = patWood(p, rings, 0.035, wide);
    float fibre = patNoise(vec3(260.0, 14.0, 260.0) * p, 2, 0.5, 260.0 * wide);
    s.baseColor = mix(vec3(0.43, 0.22, 0.085), vec3(0.16, 0.06, 0.022), ring) * (1.0 + 0.18 * fibre);
    s.roughness = 0.42 + 0.15 * ring;
    s.clearcoat = 0.25;
    s.clearcoatRoughness = 0.25;
}
