// SPDX-License-Identifier: MIT
// A torus around the y axis, or the half of it that has z >= 0.
// bounds[-0.96, -0.26, -0.96,  0.96, 0.26, 0.96]
uniform float radius;  // slider[0.3, 0.65, 0.7] From the centre to the middle of the tube, m
uniform float tube;    // slider[0.05, 0.25, 0.25] Radius of the tube, m
uniform bool cut;      // checkbox[false] Only one half

float sdf(vec3 p) {
    float whole = sdTorus(p, radius, tube);
    return cut ? opIntersection(whole, -p.z) : whole;
}
