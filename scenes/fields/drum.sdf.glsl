// SPDX-License-Identifier: MIT
// A flat round block with soft edges, lying on the origin: a podium, or on its side a disc.
// bounds[-1.8, -0.02, -1.8,  1.8, 0.42, 1.8]
uniform float radius;  // slider[0.2, 1.2, 1.75] m
uniform float height;  // slider[0.06, 0.16, 0.4] m

float sdf(vec3 p) {
    return sdRoundedCylinder(p - vec3(0.0, 0.5 * height, 0.0), radius, 0.5 * height, 0.025);
}
