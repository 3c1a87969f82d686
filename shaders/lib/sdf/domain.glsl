// SPDX-License-Identifier: MIT
// Where a shape stands: dom... takes a point and returns the point at which the shape is asked.
// A move, a turn, a mirror keep distances. Whatever stretches space has a slope...() beside it: the
// distance must be divided by that, for the part of space the shape fills.

// The shape moved by `offset`.
// lipschitz[1.0]
// example[sdBox(domTranslate(p, vec3(0.3, 0.2, 0.0)), vec3(0.5, 0.3, 0.4))]
vec3 domTranslate(vec3 p, vec3 offset) {
    return p - offset;
}

// The shape turned about the x axis by `angle` (radians, counter-clockwise seen from its tip).
// lipschitz[1.0]
// example[sdBox(domRotateX(p, 0.5), vec3(0.7, 0.3, 0.5))]
vec3 domRotateX(vec3 p, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec3(p.x, c * p.y + s * p.z, c * p.z - s * p.y);
}

// The shape turned about the y axis by `angle` (radians).
// lipschitz[1.0]
// example[sdBox(domRotateY(p, 0.5), vec3(0.7, 0.3, 0.5))]
vec3 domRotateY(vec3 p, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec3(c * p.x - s * p.z, p.y, c * p.z + s * p.x);
}

// The shape turned about the z axis by `angle` (radians).
// lipschitz[1.0]
// example[sdBox(domRotateZ(p, 0.5), vec3(0.7, 0.3, 0.5))]
vec3 domRotateZ(vec3 p, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec3(c * p.x + s * p.y, c * p.y - s * p.x, p.z);
}

// The shape turned about an axis through the origin by `angle` (radians); `axis` has length 1.
// Source: the rotation formula of Rodrigues (1840), with the angle negated.
// lipschitz[1.0]
// example[sdBox(domRotateAxis(p, vec3(0.6, 0.0, 0.8), 0.7), vec3(0.7, 0.3, 0.5))]
vec3 domRotateAxis(vec3 p, vec3 axis, float angle) {
    float c = cos(angle);
    return c * p - sin(angle) * cross(axis, p) + (1.0 - c) * dot(axis, p) * axis;
}

// A turn in a plane, for 2-D shapes: by `angle` (radians, counter-clockwise).
// lipschitz[1.0]
// example[opExtrude(sd2Box(domRotate2(p.xy, 0.5), vec2(0.7, 0.3)), p.z, 0.3)]
vec2 domRotate2(vec2 p, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec2(c * p.x + s * p.y, c * p.y - s * p.x);
}

// The shape `factor` times as large; multiply its distance by `factor` again, then it is as exact as
// before. The slope is that of the coordinates alone.
// lipschitz[1.0 / factor]
// example[1.6 * sdBoxFrame(domScale(p, 1.6), vec3(0.5, 0.4, 0.3), 0.05)]
vec3 domScale(vec3 p, float factor) {
    return p / factor;
}

// The shape stretched by a factor along each axis; multiply its distance by the smallest factor,
// which leaves a bound.
// lipschitz[1.0 / min(factors.x, min(factors.y, factors.z))]
// example[0.5 * sdSphere(domStretch(p, vec3(1.5, 0.5, 1.0)), 0.7)]
vec3 domStretch(vec3 p, vec3 factors) {
    return p / factors;
}

// What lies on the positive side of x = 0, also mirrored to the other. Exact for shapes that stay on
// the positive side.
// lipschitz[1.0]
// example[sdCapsule(domMirrorX(p), vec3(0.2, -0.5, 0.0), vec3(0.8, 0.5, 0.2), 0.15)]
vec3 domMirrorX(vec3 p) {
    return vec3(abs(p.x), p.y, p.z);
}

// What lies in front of the plane dot(p, normal) = offset, also mirrored behind it; `normal` has
// length 1.
// lipschitz[1.0]
// example[sdSphere(domMirror(p, vec3(0.6, 0.8, 0.0), 0.1) - vec3(0.5, 0.4, 0.1), 0.35)]
vec3 domMirror(vec3 p, vec3 normal, float offset) {
    return p - 2.0 * min(dot(p, normal) - offset, 0.0) * normal;
}

// Eight mirrors around the y axis: the sector 0 <= z <= x fills the whole circle.
// lipschitz[1.0]
// example[sdCapsule(domMirrorOctant(p), vec3(0.5, -0.4, 0.15), vec3(0.8, 0.4, 0.3), 0.1)]
vec3 domMirrorOctant(vec3 p) {
    vec2 q = abs(p.xz);
    return vec3(max(q.x, q.y), p.y, min(q.x, q.y));
}

// The 120 mirrors of the icosahedron: everything is folded into one cone between the axes (0, 0, 1)
// (middles of edges), (0.5257, 0, 0.8507) (corners) and (0, 0.3568, 0.9342) (faces).
// Source: the three mirrors of the Coxeter group H3 meet at angles of pi/2, pi/3 and pi/5; folding at
// one after the other ends after at most five rounds.
// lipschitz[1.0]
// example[sdCapsule(domFoldIcosahedral(p), vec3(0.0, 0.0, 0.75), vec3(0.45, 0.0, 0.73), 0.06)]
vec3 domFoldIcosahedral(vec3 p) {
    vec3 third = vec3(-0.5, -0.809016994375, 0.309016994375);
    vec3 q = p;
    for (int i = 0; i < 5; i++) {
        q = vec3(abs(q.x), abs(q.y), q.z);
        q -= 2.0 * min(dot(q, third), 0.0) * third;
    }
    return q;
}

// Revolution about the y axis: the point of a 2-D shape, whose axis stands `offset` away from it.
// As exact as the 2-D shape where that does not reach across the axis.
// lipschitz[1.0]
// example[sd2Box(domRevolve(p, 0.6), vec2(0.15, 0.4))]
vec2 domRevolve(vec3 p, float offset) {
    return vec2(length(p.xz) - offset, p.y);
}

// The shape cut at its middle planes and pulled apart by 2 `halfGaps` along each axis.
// Source: the gap is filled with copies of the cross-section, so a point between the halves sees
// none of the gap. Outside as exact as the shape; inside a bound.
// lipschitz[1.0]
// example[sdTorus(domElongate(p, vec3(0.3, 0.1, 0.0)), 0.5, 0.2)]
vec3 domElongate(vec3 p, vec3 halfGaps) {
    return p - clamp(p, -halfGaps, halfGaps);
}

// Twist about the y axis by `turn` radians a metre. Divide the distance by slopeTwist.
// lipschitz[slopeTwist(turn, radius)]
// example[sdBox(domTwist(p, 2.5), vec3(0.45, 0.9, 0.2)) / slopeTwist(2.5, 1.85)]
vec3 domTwist(vec3 p, float turn) {
    float c = cos(turn * p.y);
    float s = sin(turn * p.y);
    return vec3(c * p.x - s * p.z, p.y, s * p.x + c * p.z);
}

// How much steeper a twist makes a field within `radius` of the y axis.
// Source: a twist shears by s = turn * radius; the largest singular value of such a shear is
// (s + sqrt(s^2 + 4)) / 2.
// example[sdBox(domTwist(p, 2.5), vec3(0.45, 0.9, 0.2)) / slopeTwist(2.5, 1.85)]
float slopeTwist(float turn, float radius) {
    float s = abs(turn) * radius;
    return 0.5 * (s + sqrt(s * s + 4.0));
}

// A bar along the x axis bent upwards to a circle of `radius` about (0, radius, z). Divide the
// distance by slopeBend.
// Source: polar coordinates about the middle of the circle; lengths along the neutral fibre y = 0
// stay as they are.
// lipschitz[slopeBend(radius, reach)]
// example[sdBox(domBend(p + vec3(0.0, 0.7, 0.0), 2.2), vec3(1.3, 0.15, 0.4)) / slopeBend(2.2, 2.0)]
vec3 domBend(vec3 p, float radius) {
    float y = radius - p.y;
    return vec3(radius * atan(p.x, y), radius - length(vec2(p.x, y)), p.z);
}

// How much steeper a bend makes a field of what reaches `reach` from the x axis to the middle of
// the circle: circles there are shorter by (radius - reach) / radius. The field is asked no nearer
// to the middle only if the shape's bounds keep rays out of there.
// example[sdBox(domBend(p + vec3(0.0, 0.7, 0.0), 2.2), vec3(1.3, 0.15, 0.4)) / slopeBend(2.2, 2.0)]
float slopeBend(float radius, float reach) {
    return radius / max(radius - reach, 1.0e-3 * radius);
}

// Taper: cross-sections at height y are 1 + rate * y times as large (at least a tenth). Divide the
// distance by slopeTaper.
// lipschitz[slopeTaper(rate, radius, smallest)]
// example[sdBox(domTaper(p, -0.4), vec3(0.5, 0.9, 0.5)) / slopeTaper(-0.4, 3.9, 0.48)]
vec3 domTaper(vec3 p, float rate) {
    float size = max(1.0 + rate * p.y, 0.1);
    return vec3(p.x / size, p.y, p.z / size);
}

// How much steeper a taper makes a field, where the shape before it reaches `radius` from the y
// axis and the cross-sections shrink to `smallest` times their size.
// Source: the derivative is a scaling by 1 / smallest and a shear by radius * rate / smallest; the
// norm of a sum is at most the sum of the norms.
// example[sdBox(domTaper(p, -0.4), vec3(0.5, 0.9, 0.5)) / slopeTaper(-0.4, 3.9, 0.48)]
float slopeTaper(float rate, float radius, float smallest) {
    return max(1.0, 1.0 / smallest) + radius * abs(rate) / smallest;
}
