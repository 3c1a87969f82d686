// A box with rounded edges. What it calls is explained in docs/sdf.md.
// bounds[-4.1, -0.25, -4.1,  4.1, 0.01, 4.1]
uniform float halfWidth; // slider[0.5, 4.0, 4.0] Half of the width, m
uniform float edge;      // slider[0.0, 0.04, 0.2] Radius of the edges, m

float sdf(vec3 p) {
    return sdRoundedBox(p + vec3(0.0, 0.12, 0.0), vec3(halfWidth, 0.12, halfWidth), edge);
}
