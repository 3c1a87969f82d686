// SPDX-License-Identifier: MIT
// A ball of field stone, not quite round.
// bounds[-0.56, -0.56, -0.56, 0.56, 0.56, 0.56]
float sdf(vec3 p) {
    return opDisplace(sdSphere(p, 0.47), 0.045 * noiseGradient(2.6 * p), 0.045 * 2.6 * 2.8);
}
