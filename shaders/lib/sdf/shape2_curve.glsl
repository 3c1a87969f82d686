// SPDX-License-Identifier: MIT
// Plane shapes whose distance is the root of an equation.

// An ellipse about the origin.
// Source: the nearest point of the curve to q is (r.x^2 q.x / (t + r.x^2), ...) for the one t that
// puts it on the curve (Eberly, Distance from a Point to an Ellipse, 2013). One over the length of
// (r.x q.x / (t + r.x^2), ...) is nearly linear in t, so Newton's method on it needs two to four
// steps outside, ten deep inside (More and Sorensen 1983, for trust regions).
// exact
// bounds[-halfAxes, halfAxes]
// example[sd2Ellipse(p, vec2(0.9, 0.45))]
// example[sd2Ellipse(p, vec2(0.2, 0.9))]
float sd2Ellipse(vec2 p, vec2 halfAxes) {
    vec2 r = halfAxes;
    vec2 q = max(abs(p), 1.0e-6 * r);
    vec2 rr = r * r;
    float t = max(r.x * q.x - rr.x, r.y * q.y - rr.y);
    for (int i = 0; i < 10; i++) {
        vec2 v = r * q / (t + rr);
        float size = length(v);
        t += (size - 1.0) * size * size / dot(v, v / (t + rr));
        if (abs(size - 1.0) < 1.0e-6) break;
    }
    float away = length(q - rr * q / (t + rr));
    return length(q / r) < 1.0 ? -away : away;
}

// All above the parabola y = steepness x^2.
// Source: where the line to a point of the curve is perpendicular to it, a cubic in x.
// exact
// example[sd2Parabola(p + vec2(0.0, 0.5), 1.5)]
float sd2Parabola(vec2 p, float steepness) {
    float kk = 2.0 * steepness * steepness;
    vec3 x = numCubicRoots(0.0, (1.0 - 2.0 * steepness * p.y) / kk, -p.x / kk);
    vec3 dx = x - p.x;
    vec3 dy = steepness * x * x - p.y;
    vec3 squared = dx * dx + dy * dy;
    float away = sqrt(min(squared.x, min(squared.y, squared.z)));
    return p.y > steepness * p.x * p.x ? -away : away;
}

// Distance to the quadratic Bezier curve from a to c with the control point b, which has no inside;
// subtract half a width.
// exact
// example[sd2Bezier(p, vec2(-0.8, -0.5), vec2(0.1, 1.3), vec2(0.7, -0.4)) - 0.08]
float sd2Bezier(vec2 p, vec2 a, vec2 b, vec2 c) {
    vec2 u = b - a;
    vec2 v = a - 2.0 * b + c;
    vec2 o = a - p;
    vec3 t = numBezierFeet(dot(u, u), dot(u, v), dot(v, v), dot(u, o), dot(v, o));
    float first = length(o + t.x * (2.0 * u + t.x * v));
    float second = length(o + t.y * (2.0 * u + t.y * v));
    return min(min(first, second), length(o + t.z * (2.0 * u + t.z * v)));
}
