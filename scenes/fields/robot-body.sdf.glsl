// SPDX-License-Identifier: MIT
// The robot's body. The origin lies between the hips; the head sits on (0, 0.80, 0).
// bounds[-0.52, -0.20, -0.42,  0.52, 0.90, 0.44]
// parts[shell, panel, trim, metal, lamp, belly]
uniform float breath;  // slider[-1.0, 0.0, 1.0] From breathed out to breathed in

void take(inout vec2 nearest, float d, float part) {
    if (d < nearest.x) nearest = vec2(d, part);
}

vec2 sdf(vec3 p) {
    float swell = 0.008 * breath;
    // Deeper than it is wide would look heavy: the torso is pressed in z.
    const float press = 0.86;
    vec3 q = vec3(p.x, p.y, p.z / press);
    float torso = (sdRoundCone(q - vec3(0.0, 0.20, 0.0), 0.365 + swell, 0.255 + 0.7 * swell, 0.33)) * press;
    float seam = max(abs(p.y - 0.235) - 0.006, -(torso + 0.014));
    float shoulders = max(abs(abs(p.x) - 0.22) - 0.005, -(torso + 0.010));
    shoulders = max(shoulders, 0.52 - p.y);
    float pocket = max(sd2RoundedBox(p.xy - vec2(0.0, 0.41), vec2(0.17, 0.115), 0.05), 0.05 - p.z);
    float shell = opSmoothIntersection(max(torso, -min(seam, shoulders)), -pocket, 0.02);
    bool lower = p.y < 0.235;
    vec2 nearest = vec2(shell, lower ? 5.0 : 0.0);

    float panel = opSmoothIntersection(torso + 0.020, max(sd2RoundedBox(p.xy - vec2(0.0, 0.41),
                            vec2(0.164, 0.109), 0.045), 0.05 - p.z), 0.015);
    take(nearest, panel, 1.0);

    // Pelvis and hips, shoulder sockets.
    vec3 m = vec3(abs(p.x), p.yz);
    float pelvis = opSmoothUnion(length(p - vec3(0.0, -0.02, 0.0)) - 0.17,
                             length(m - vec3(0.17, -0.03, 0.0)) - 0.115, 0.06);
    take(nearest, pelvis, 2.0);
    take(nearest, length(m - vec3(0.335, 0.545, 0.0)) - 0.105, 2.0);

    // Neck: three rings of rubber.
    vec3 n = p - vec3(0.0, 0.80, 0.0);
    n.y -= 0.042 * clamp(floor(n.y / 0.042 + 0.5), -2.0, 1.0);
    take(nearest, sdTorus(n, 0.095, 0.027), 2.0);
    take(nearest, max(length(p.xz) - 0.10, abs(p.y - 0.78) - 0.09), 2.0);
    take(nearest, sdTorus(p - vec3(0.0, 0.755, 0.0), 0.155, 0.03), 3.0);
    return nearest;
}
