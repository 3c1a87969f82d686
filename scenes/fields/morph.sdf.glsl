// SPDX-License-Identifier: MIT
// To a topologist a torus and a mug are the same thing: a body with one hole. Here the one becomes
// the other. One side of the ring swells into a cylinder, the rest thins to a handle; then a hollow
// sinks in from above. Every step is a smooth union or difference of exact distances, so the slope
// never exceeds 1. It stands on y = 0 at every moment.
// bounds[-0.72, -0.05, -0.48,  0.82, 1.30, 0.48]
uniform float morph;   // slider[0.0, 0.0, 1.0] From torus to mug
uniform float moving;  // slider[0.0, 0.0, 1.0] Back and forth with time
uniform float period;  // slider[1.0, 8.0, 60.0] Seconds there and back

float sdf(vec3 p) {
    float m = mix(morph, 0.5 - 0.5 * cos(6.2831853 * time / period), moving);
    float grow = smoothstep(0.0, 0.62, m);
    float hollow = smoothstep(0.5, 1.0, m);

    float ringRadius = mix(0.40, 0.215, grow);
    float tube = mix(0.165, 0.052, grow);
    float halfHeight = mix(0.08, 0.43, grow);
    float foot = max(halfHeight, ringRadius + tube);
    vec3 q = p - vec3(0.0, foot, 0.0);
    float ring = sdTorus((q - vec3(mix(0.0, 0.40, grow), 0.0, 0.0)).xzy, ringRadius, tube);
    float body = sdRoundedCylinder(q - vec3(mix(-0.40, 0.0, grow), 0.0, 0.0), mix(0.08, 0.37, grow),
                          halfHeight, mix(0.08, 0.07, grow));
    float solid = opSmoothUnion(ring, body, mix(0.01, 0.09, grow) + 0.3 * grow * (1.0 - grow));

    // The hollow is a cylinder that is open above: it waits above all of it, then its bottom sinks,
    // and it widens.
    float bottom = mix(foot + 0.1, -halfHeight + 0.065, hollow);
    vec3 h = q - vec3(0.0, bottom + 1.0, 0.0);
    float inside = sdRoundedCylinder(h, mix(0.12, 0.315, hollow), 1.0, 0.06);
    return opSmoothIntersection(solid, -inside, 0.035);
}
