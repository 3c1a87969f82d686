// SPDX-License-Identifier: MIT
// Where a picture lies on a shape: uv... takes a place of the object (Surface.localPosition), and
// where the side matters its normal (Surface.localNormal), and returns a place of a plane. Those
// that return metres return widths, too: abs(uvBox(s.localFootprint, n)) is the pixel's there.

// Round the y axis and from pole to pole, both from 0 to 1, as the built-in sphere has them: u grows
// from +x towards -z, v upwards. The seam is on the +x side: patterns that repeat a whole number
// of times do not show it.
// shape[sdSphere(p, 1.0)]
// pattern[mix(vec3(0.08, 0.2, 0.45), vec3(0.85), patChecker(vec2(16.0, 8.0) * uvSphere(p), vec2(0.04)))]
vec2 uvSphere(vec3 p) {
    float angle = atan(-p.z, p.x) / 6.28318530718;
    return vec2(angle < 0.0 ? angle + 1.0 : angle,
                0.5 + atan(p.y, length(p.xz)) / 3.14159265359);
}

// Round the y axis, from 0 to 1 as uvSphere does, and upwards in metres.
// shape[sdCylinder(p, 0.8, 0.95)]
// pattern[mix(vec3(0.08, 0.2, 0.45), vec3(0.85), patChecker(vec2(16.0, 4.0) * uvCylinder(p), vec2(0.05)))]
vec2 uvCylinder(vec3 p) {
    float angle = atan(-p.z, p.x) / 6.28318530718;
    return vec2(angle < 0.0 ? angle + 1.0 : angle, p.y);
}

// The plane across an axis, as metres: 0: (z, y), 1: (x, z), 2: (x, y).
// pattern[mix(vec3(0.08, 0.2, 0.45), vec3(0.85), patChecker(4.0 * uvPlane(p, 2), 4.0 * uvPlane(w, 2)))]
vec2 uvPlane(vec3 p, int axis) {
    return axis == 0 ? p.zy : axis == 1 ? p.xz : p.xy;
}

// The side of a box that a point belongs to by its normal, in metres. Every side is the right way
// round for whoever looks at it: u to the right and v up (on top, v to the back).
// pattern[mix(vec3(0.08, 0.2, 0.45), vec3(0.85), patChecker(4.0 * uvBox(p, n), 4.0 * abs(uvBox(w, n))))]
vec2 uvBox(vec3 p, vec3 n) {
    vec3 a = abs(n);
    vec2 uv = vec2(n.z < 0.0 ? -p.x : p.x, p.y);
    if (a.x > a.y && a.x >= a.z) uv = vec2(n.x < 0.0 ? p.z : -p.z, p.y);
    if (a.y >= a.x && a.y >= a.z) uv = vec2(p.x, n.y < 0.0 ? p.z : -p.z);
    return uv;
}

// How much of each of the three planes is seen at a place with this normal; the sum is 1. The larger
// `sharpness`, the narrower the blend: 1 is soft, 16 nearly uvBox. For a pattern f in a plane:
//   vec3 share = uvTriplanar(s.localNormal, 4.0);
//   for (int i = 0; i < 3; i++) sum += share[i] * f(uvPlane(s.localPosition, i));
// which writes f once, and so compiles once.
// Source: Golus, Normal Mapping for a Triplanar Shader, 2017, has the history.
// shape[sdSphere(p, 1.0)]
// pattern[uvTriplanar(n, 4.0)]
vec3 uvTriplanar(vec3 n, float sharpness) {
    vec3 a = abs(n) / max(abs(n.x), max(abs(n.y), abs(n.z)));
    vec3 share = pow(max(a, 1.0e-4), vec3(sharpness));
    return share / (share.x + share.y + share.z);
}

// A normal bent by a height over the surface: `gradient` is how much the height (m) grows a metre
// along each axis, in the same space as the normal. Its part along the normal does not count.
// Source: Mikkelsen, Bump Mapping Unparametrized Surfaces on the GPU, 2010: the surface gradient.
// shape[sdSphere(p, 1.0)]
// pattern[vec3(0.15 + 0.8 * max(dot(uvBump(n, 0.6 * cos(12.0 * p)), vec3(0.35, 0.8, 0.49)), 0.0))]
vec3 uvBump(vec3 n, vec3 gradient) {
    return normalize(n - (gradient - dot(gradient, n) * n));
}
