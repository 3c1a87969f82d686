// SPDX-License-Identifier: MIT
// A steel crate: a box with a frame, a panel set back in each side, and rivets.
// bounds[-0.44, -0.44, -0.44, 0.44, 0.44, 0.44]

float sdf(vec3 p) {
    vec3 a = abs(p);
    // The largest coordinate is that along the normal of the side.
    vec2 side = a.x > a.y && a.x > a.z ? a.yz : a.y > a.z ? a.xz : a.xy;
    float height = max(a.x, max(a.y, a.z));
    float body = sdRoundedBox(p, vec3(0.40), 0.008);
    float panel = opSmoothDifference(body, sdBox(vec3(side, height - 0.40), vec3(0.30, 0.30, 0.018)), 0.006);
    vec2 rivet = side - 0.35;
    float head = length(vec3(rivet, height - 0.392)) - 0.022;
    return 0.9 * opSmoothUnion(panel, head, 0.004);
}
