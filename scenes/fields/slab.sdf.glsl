// A box with rounded edges: exact outside, and a step never leads past the surface.
// bounds[-4.1, -0.25, -4.1,  4.1, 0.01, 4.1]
uniform float halfWidth; // slider[0.5, 4.0, 4.0] Half of the width, m
uniform float edge;      // slider[0.0, 0.04, 0.2] Radius of the edges, m

float sdf(vec3 p) {
    vec3 halfSize = vec3(halfWidth, 0.12, halfWidth);
    vec3 q = abs(p + vec3(0.0, 0.12, 0.0)) - (halfSize - edge);
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - edge;
}
