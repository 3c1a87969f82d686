// SPDX-License-Identifier: MIT
// Solids whose distance is the root of an equation, or a bound of one.

// An ellipsoid.
// Source: as sd2Ellipse, with one more coordinate.
// exact
// bounds[-halfAxes, halfAxes]
// example[sdEllipsoid(p, vec3(0.85, 0.45, 0.6))]
// example[sdEllipsoid(p, vec3(0.2, 0.9, 0.5))]
float sdEllipsoid(vec3 p, vec3 halfAxes) {
    vec3 r = halfAxes;
    vec3 q = max(abs(p), 1.0e-6 * r);
    vec3 rr = r * r;
    vec3 start = r * q - rr;
    float t = max(start.x, max(start.y, start.z));
    for (int i = 0; i < 10; i++) {
        vec3 v = r * q / (t + rr);
        float size = length(v);
        t += (size - 1.0) * size * size / dot(v, v / (t + rr));
        if (abs(size - 1.0) < 1.0e-6) break;
    }
    float away = length(q - rr * q / (t + rr));
    return length(q / r) < 1.0 ? -away : away;
}

// An ellipsoid for the price of a sphere. At least the smallest half axis divided by the largest of
// the true distance.
// Source: k = |p / r| is 1 on the surface and 1 / min(r) steep. The surface point p / k is
// (k - 1) |p / k| <= (k - 1) max(r) away.
// bound
// lipschitz[1.0]
// bounds[-halfAxes, halfAxes]
// example[sdEllipsoidBound(p, vec3(0.85, 0.45, 0.6))]
float sdEllipsoidBound(vec3 p, vec3 halfAxes) {
    return (length(p / halfAxes) - 1.0) * min(halfAxes.x, min(halfAxes.y, halfAxes.z));
}

// An ellipsoid of revolution around the y axis.
// exact
// bounds[vec3(-radius, -halfHeight, -radius), vec3(radius, halfHeight, radius)]
// example[sdSpheroid(p, 0.8, 0.4)]
float sdSpheroid(vec3 p, float radius, float halfHeight) {
    return sd2Ellipse(vec2(length(p.xz), p.y), vec2(radius, halfHeight));
}

// A bowl without rim: all above y = steepness (x^2 + z^2).
// exact
// example[sdParaboloid(p + vec3(0.0, 0.6, 0.0), 1.5)]
float sdParaboloid(vec3 p, float steepness) {
    return sd2Parabola(vec2(length(p.xz), p.y), steepness);
}

// A tube of `radius` along the quadratic Bezier curve from a to c with the control point b.
// exact
// bounds[min(a, min(b, c)) - radius, max(a, max(b, c)) + radius]
// example[sdBezier(p, vec3(-0.8, -0.5, 0.0), vec3(0.0, 1.2, 0.4), vec3(0.8, -0.5, 0.2), 0.1)]
float sdBezier(vec3 p, vec3 a, vec3 b, vec3 c, float radius) {
    vec3 u = b - a;
    vec3 v = a - 2.0 * b + c;
    vec3 o = a - p;
    vec3 t = numBezierFeet(dot(u, u), dot(u, v), dot(v, v), dot(u, o), dot(v, o));
    float first = length(o + t.x * (2.0 * u + t.x * v));
    float second = length(o + t.y * (2.0 * u + t.y * v));
    return min(min(first, second), length(o + t.z * (2.0 * u + t.z * v))) - radius;
}

// A wire of radius `wire` wound around the y axis without end: `coil` is the radius of the winding,
// `rise` the height of a turn.
// Source: the wire's own height above the point, times the cosine of its pitch, and less near the
// axis, where the angle turns quickly. The pitch shears this by s = pi sin(pitch); divided by the
// largest singular value of such a shear it is a bound.
// bound
// lipschitz[1.0]
// example[sdHelix(p, 0.5, 0.5, 0.1)]
// example[sdHelix(p, 0.6, 1.1, 0.15)]
float sdHelix(vec3 p, float coil, float rise, float wire) {
    float radius = length(p.xz);
    float perTurn = rise / 6.28318530718;
    float cosine = coil / sqrt(coil * coil + perTurn * perTurn);
    float sine = perTurn / sqrt(coil * coil + perTurn * perTurn);
    float height = p.y - perTurn * atan(p.z, p.x);
    height -= rise * round(height / rise);
    float across = height * cosine * min(radius / coil, 1.0);
    float s = 3.14159265359 * sine;
    return length(vec2(radius - coil, across)) / (0.5 * (s + sqrt(s * s + 4.0))) - wire;
}

// A spring: a helix cut off at y = +-halfHeight, with flat ends.
// bound
// lipschitz[1.0]
// bounds[vec3(-coil - 4.0 * wire, -halfHeight, -coil - 4.0 * wire), vec3(coil + 4.0 * wire, halfHeight, coil + 4.0 * wire)]
// example[sdSpring(p, 0.5, 0.4, 0.08, 0.7)]
float sdSpring(vec3 p, float coil, float rise, float wire, float halfHeight) {
    return max(sdHelix(p, coil, rise, wire), abs(p.y) - halfHeight);
}
