// SPDX-License-Identifier: MIT
// A turned wooden bowl.
// bounds[-0.31, -0.01, -0.31, 0.31, 0.26, 0.31]
float sdf(vec3 p) {
    vec2 q = domRevolve(p, 0.0);
    float cup = abs(length(q - vec2(0.0, 0.36)) - 0.315) - 0.016;
    cup = opSmoothIntersection(cup, q.y - 0.225, 0.02);
    float foot = sd2RoundedBox(q - vec2(0.0, 0.022), vec2(0.13, 0.022), 0.008);
    return opSmoothUnion(cup, foot, 0.035);
}
