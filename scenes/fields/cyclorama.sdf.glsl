// SPDX-License-Identifier: MIT
// The backdrop of a photographer's studio: a floor that turns up into a wall without an edge.
// The origin lies on the floor, the wall is behind, towards -z.
// bounds[-20, -0.5, -7,  20, 12, 12]
uniform float depth;   // slider[1.0, 4.0, 6.0] From the origin to the wall, m
uniform float sweep;  // slider[0.5, 2.5, 4.0] Radius of the turn, m

float sdf(vec3 p) {
    vec2 q = vec2(p.z + depth, p.y);
    // Inside the turn the distance is that to a circle, elsewhere that to the nearer plane.
    float backdrop = max(q.x, q.y) < sweep ? sweep - length(q - sweep) : min(q.x, q.y);
    // It ends within its bounds.
    vec3 ends = max(p - vec3(19.5, 11.5, 11.5), vec3(-19.5, -0.4, -6.8) - p);
    return max(backdrop, max(ends.x, max(ends.y, ends.z)));
}
