// SPDX-License-Identifier: MIT
// The robot's head, about one unit across. The origin is the joint of the neck; +z is the face.
// bounds[-0.67, -0.06, -0.48,  0.67, 1.42, 0.48]
// parts[shell, visor, trim, ear, metal, lamp]
uniform float roundness;  // slider[0.10, 0.29, 0.36] Radius of the head's edges
uniform float antenna;    // slider[0.0, 0.30, 0.40] Length of the antenna

const vec3 middle = vec3(0.0, 0.42, 0.0);

// A cylinder along x with rounded edges.
float disc(vec3 p, float radius, float halfLength, float r) {
    vec2 q = vec2(length(p.yz) - radius, abs(p.x) - halfLength) + r;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - r;
}

void take(inout vec2 nearest, float d, float part) {
    if (d < nearest.x) nearest = vec2(d, part);
}

vec2 sdf(vec3 p) {
    vec3 q = p - middle;
    float skull = sdRoundedBox(q, vec3(0.50, 0.38, 0.42), roundness);

    // The face: a pocket in the shell, in which glass lies a little below the surface.
    vec2 face = q.xy - vec2(0.0, 0.0);
    float pocket = max(sd2RoundedBox(face, vec2(0.375, 0.265), 0.17), 0.1 - q.z);
    float seam = max(abs(q.z + 0.10) - 0.006, -(skull + 0.014));
    float shell = opSmoothIntersection(max(skull, -seam), -pocket, 0.025);
    vec2 nearest = vec2(shell, 0.0);

    float glass = opSmoothIntersection(skull + 0.022, max(sd2RoundedBox(face, vec2(0.369, 0.259), 0.165), 0.1 - q.z),
                            0.03);
    take(nearest, glass, 1.0);

    // Ears: a dark cup, a glowing ring of jelly, a metal cap. One side, mirrored.
    vec3 e = vec3(abs(q.x), q.y + 0.01, q.z + 0.02);
    float cup = disc(e - vec3(0.50, 0.0, 0.0), 0.185, 0.045, 0.025);
    float jelly = disc(e - vec3(0.555, 0.0, 0.0), 0.15, 0.045, 0.04);
    float cap = disc(e - vec3(0.60, 0.0, 0.0), 0.07, 0.028, 0.018);
    take(nearest, cup, 2.0);
    take(nearest, jelly, 3.0);
    take(nearest, cap, 4.0);

    // Antenna: a dark socket, a metal stalk, and a lamp.
    vec3 a = q - vec3(0.0, 0.37, -0.06);
    float socket = opSmoothUnion(sdRoundedBox(a, vec3(0.075, 0.03, 0.075), 0.03),
                             sdCapsule(a, vec3(0.0), vec3(0.0, 0.06, 0.0), 0.035), 0.04);
    take(nearest, socket, 2.0);
    vec3 tip = vec3(0.0, 0.05 + antenna, -0.03 - 0.1 * antenna);
    take(nearest, sdCapsule(a, vec3(0.0), tip, 0.016), 4.0);
    take(nearest, length(a - tip - vec3(0.0, 0.05, 0.0)) - 0.075, 5.0);

    // The neck's collar.
    float collar = length(vec2(length(p.xz) - 0.17, p.y - 0.035)) - 0.032;
    take(nearest, collar, 4.0);
    return nearest;
}
