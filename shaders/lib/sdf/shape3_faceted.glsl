// SPDX-License-Identifier: MIT
// Solids with flat faces. The regular ones are exact through their mirrors: a point is folded into
// the cone between the middle of one face, of one of its edges, and one of its corners; the nearest
// point of the solid is in the same cone.

// In such a cone: `face`, `edge` and `corner` are the three points named above.
// Source: the plane of the face, unless the foot lies beyond the edge; then the half edge.
// exact
// example[sdFacetInCone(domFoldIcosahedral(p), vec3(0.368011778, 0.0, 0.595455566), vec3(0.0, 0.0, 0.822898973), vec3(0.0, 0.314319439, 0.822898973))]
float sdFacetInCone(vec3 p, vec3 face, vec3 edge, vec3 corner) {
    vec3 q = p - edge;
    if (dot(q, edge - face) <= 0.0) return dot(p - face, normalize(face));
    vec3 along = corner - edge;
    return length(q - along * clamp(dot(q, along) / dot(along, along), 0.0, 1.0));
}

// A regular tetrahedron with corners at (1, 1, 1), (1, -1, -1), (-1, 1, -1) and (-1, -1, 1) times
// `halfEdge`, which is half the edge of the cube around it.
// Source: its mirrors swap two coordinates, or swap and negate them; the sign of x y z stays.
// exact
// bounds[vec3(-halfEdge), vec3(halfEdge)]
// example[sdTetrahedron(p, 0.6)]
float sdTetrahedron(vec3 p, float halfEdge) {
    vec3 q = abs(p);
    float high = max(q.x, max(q.y, q.z));
    float low = min(q.x, min(q.y, q.z));
    float middle = q.x + q.y + q.z - high - low;
    low = p.x * p.y * p.z < 0.0 ? -low : low;
    vec3 face = halfEdge / 3.0 * vec3(1.0, 1.0, -1.0);
    return sdFacetInCone(vec3(high, middle, low), face, vec3(halfEdge, 0.0, 0.0), vec3(halfEdge));
}

// A regular octahedron with its corners on the axes at `reach`.
// Source: its mirrors are those of the cube: signs and order of the coordinates.
// exact
// bounds[vec3(-reach), vec3(reach)]
// example[sdOctahedron(p, 0.9)]
float sdOctahedron(vec3 p, float reach) {
    vec3 q = abs(p);
    float high = max(q.x, max(q.y, q.z));
    float low = min(q.x, min(q.y, q.z));
    float middle = q.x + q.y + q.z - high - low;
    return sdFacetInCone(vec3(high, middle, low), vec3(reach / 3.0),
                         vec3(0.5 * reach, 0.5 * reach, 0.0), vec3(reach, 0.0, 0.0));
}

// A regular dodecahedron; `radius` goes to the middles of its faces.
// exact
// bounds[vec3(-1.2584086 * radius), vec3(1.2584086 * radius)]
// example[sdDodecahedron(p, 0.7)]
float sdDodecahedron(vec3 p, float radius) {
    vec3 face = vec3(0.525731112119, 0.0, 0.850650808352);
    vec3 corner = vec3(0.0, 0.356822089773, 0.934172358963);
    return sdFacetInCone(domFoldIcosahedral(p), radius * face,
                         vec3(0.0, 0.0, radius / face.z), corner * (radius / dot(corner, face)));
}

// A regular icosahedron; `radius` goes to the middles of its faces.
// exact
// bounds[vec3(-1.2584086 * radius), vec3(1.2584086 * radius)]
// example[sdIcosahedron(p, 0.7)]
float sdIcosahedron(vec3 p, float radius) {
    vec3 face = vec3(0.0, 0.356822089773, 0.934172358963);
    vec3 corner = vec3(0.525731112119, 0.0, 0.850650808352);
    return sdFacetInCone(domFoldIcosahedral(p), radius * face,
                         vec3(0.0, 0.0, radius / face.z), corner * (radius / dot(corner, face)));
}

// A rhombic dodecahedron, which fills space; `radius` goes to the middles of its faces.
// exact inside
// lipschitz[1.0]
// bounds[vec3(-1.4142136 * radius), vec3(1.4142136 * radius)]
// example[sdRhombicDodecahedron(p, 0.6)]
float sdRhombicDodecahedron(vec3 p, float radius) {
    vec3 q = abs(p);
    return max(q.x + q.y, max(q.y + q.z, q.z + q.x)) * 0.70710678119 - radius;
}

// An octahedron with its corners cut off to squares, which fills space; `radius` goes to the middles
// of those.
// Source: six planes at radius and eight at sqrt(3) / 2 of it, where all edges are equal.
// exact inside
// lipschitz[1.0]
// bounds[vec3(-radius), vec3(radius)]
// example[sdTruncatedOctahedron(p, 0.75)]
float sdTruncatedOctahedron(vec3 p, float radius) {
    vec3 q = abs(p);
    float squares = max(q.x, max(q.y, q.z)) - radius;
    return max(squares, (q.x + q.y + q.z) * 0.57735026919 - 0.86602540378 * radius);
}

// A football: an icosahedron with its corners cut off to pentagons; `radius` goes to the middles of
// the hexagons.
// Source: all edges are equal where the pentagons are 1.0275766 times as far out.
// exact inside
// lipschitz[1.0]
// bounds[vec3(-1.1 * radius), vec3(1.1 * radius)]
// example[sdTruncatedIcosahedron(p, 0.7)]
float sdTruncatedIcosahedron(vec3 p, float radius) {
    vec3 q = domFoldIcosahedral(p);
    float hexagons = dot(q, vec3(0.0, 0.356822089773, 0.934172358963)) - radius;
    return max(hexagons, dot(q, vec3(0.525731112119, 0.0, 0.850650808352)) - 1.0275766 * radius);
}

// A triangle in space, `thickness` thick to both sides and around its rim.
// Source: the plane, where the foot is inside of all three edges; else the nearest edge.
// exact
// bounds[min(a, min(b, c)) - thickness, max(a, max(b, c)) + thickness]
// example[sdTriangle(p, vec3(-0.7, -0.4, 0.2), vec3(0.8, -0.3, 0.0), vec3(0.0, 0.7, -0.3), 0.05)]
float sdTriangle(vec3 p, vec3 a, vec3 b, vec3 c, float thickness) {
    vec3 normal = cross(b - a, c - a);
    bool within = dot(cross(b - a, p - a), normal) > 0.0 &&
                  dot(cross(c - b, p - b), normal) > 0.0 && dot(cross(a - c, p - c), normal) > 0.0;
    float plane = abs(dot(p - a, normal)) / length(normal);
    float rim = min(min(sdCapsule(p, a, b, 0.0), sdCapsule(p, b, c, 0.0)), sdCapsule(p, c, a, 0.0));
    return (within ? plane : rim) - thickness;
}

// A flat convex quadrangle in space, `thickness` thick to both sides and around its rim.
// exact
// bounds[min(min(a, b), min(c, d)) - thickness, max(max(a, b), max(c, d)) + thickness]
// example[sdQuad(p, vec3(-0.7, -0.4, 0.2), vec3(0.8, -0.4, 0.2), vec3(0.5, 0.6, -0.3), vec3(-0.5, 0.6, -0.3), 0.05)]
float sdQuad(vec3 p, vec3 a, vec3 b, vec3 c, vec3 d, float thickness) {
    return min(sdTriangle(p, a, b, c, thickness), sdTriangle(p, a, c, d, thickness));
}

// A pyramid on a square: base at y = 0, `halfBase` from its middle to its edges, tip at
// (0, height, 0).
// Source: mirrored in three planes, one side and a part of the base are left.
// exact
// bounds[vec3(-halfBase, 0.0, -halfBase), vec3(halfBase, height, halfBase)]
// example[sdPyramid(p + vec3(0.0, 0.45, 0.0), 0.65, 1.0)]
float sdPyramid(vec3 p, float halfBase, float height) {
    vec3 q = domMirrorOctant(p);
    vec3 tip = vec3(0.0, height, 0.0);
    vec3 edge = vec3(halfBase, 0.0, halfBase);
    float side = sdTriangle(q, tip, edge, vec3(halfBase, 0.0, -halfBase), 0.0);
    float base = length(vec3(max(q.x - halfBase, 0.0), q.y, max(q.z - halfBase, 0.0)));
    bool within = q.y > 0.0 && q.x * height < halfBase * (height - q.y);
    float away = min(side, base);
    return within ? -away : away;
}

// A prism with a regular base of `count` edges around the y axis; `radius` goes to the middles of its
// sides.
// exact
// bounds[vec3(-radius / cos(3.14159265359 / count), -halfHeight, -radius / cos(3.14159265359 / count)), vec3(radius / cos(3.14159265359 / count), halfHeight, radius / cos(3.14159265359 / count))]
// example[sdPrism(p, 5.0, 0.6, 0.4)]
float sdPrism(vec3 p, float count, float radius, float halfHeight) {
    return opExtrude(sd2Polygon(p.xz, count, radius), p.y, halfHeight);
}

// A prism with three sides.
// exact
// bounds[vec3(-2.0 * radius, -halfHeight, -2.0 * radius), vec3(2.0 * radius, halfHeight, 2.0 * radius)]
// example[sdTriangularPrism(p, 0.4, 0.5)]
float sdTriangularPrism(vec3 p, float radius, float halfHeight) {
    return sdPrism(p, 3.0, radius, halfHeight);
}

// A prism with six sides.
// Source: mirrored, the sides to +-z and the next are left.
// exact
// bounds[vec3(-1.1547006 * radius, -halfHeight, -radius), vec3(1.1547006 * radius, halfHeight, radius)]
// example[sdHexagonalPrism(p, 0.6, 0.4)]
float sdHexagonalPrism(vec3 p, float radius, float halfHeight) {
    vec2 q = abs(p.xz);
    vec2 mirror = vec2(0.86602540378, -0.5);
    q -= 2.0 * max(dot(q, mirror), 0.0) * mirror;
    vec2 away = vec2(max(abs(q.x) - 0.57735026919 * radius, 0.0), q.y - radius);
    return opExtrude(away.x > 0.0 ? length(away) : away.y, p.y, halfHeight);
}

// A rhombus in the plane z = 0, extended to both sides of it, with its edges rounded by `edge`.
// exact
// bounds[vec3(-halfSize - edge, -halfHeight - edge), vec3(halfSize + edge, halfHeight + edge)]
// example[sdRhombus(p, vec2(0.8, 0.5), 0.15, 0.08)]
float sdRhombus(vec3 p, vec2 halfSize, float halfHeight, float edge) {
    return opExtrude(sd2Rhombus(p.xy, halfSize), p.z, halfHeight) - edge;
}
