// SPDX-License-Identifier: MIT
// Plane shapes with straight edges, to extrude (opExtrude) or revolve (domRevolve); y points up. All
// are distances to the nearest edge, negative inside.

// A half plane: all below y = 0.
// exact
// example[sd2HalfPlane(p)]
float sd2HalfPlane(vec2 p) {
    return p.y;
}

// A rectangle.
// Source: beyond a corner the distance to it; elsewhere to the nearer pair of edges.
// exact
// bounds[-halfSize, halfSize]
// example[sd2Box(p, vec2(0.8, 0.5))]
float sd2Box(vec2 p, vec2 halfSize) {
    vec2 q = abs(p) - halfSize;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
}

// A rectangle with rounded corners; `halfSize` includes them.
// Source: a smaller rectangle, grown by the radius.
// exact
// bounds[-halfSize, halfSize]
// example[sd2RoundedBox(p, vec2(0.8, 0.5), 0.2)]
float sd2RoundedBox(vec2 p, vec2 halfSize, float radius) {
    return sd2Box(p, halfSize - radius) - radius;
}

// Distance to the line from a to b, which has no inside; subtract half a width.
// Source: the foot of the perpendicular, kept between the ends.
// exact
// example[sd2Segment(p, vec2(-0.6, -0.4), vec2(0.7, 0.3)) - 0.1]
float sd2Segment(vec2 p, vec2 a, vec2 b) {
    vec2 along = b - a;
    vec2 q = p - a;
    return length(q - along * clamp(dot(q, along) / dot(along, along), 0.0, 1.0));
}

// A rectangle with the middles of two sides at a and b.
// exact
// example[sd2OrientedBox(p, vec2(-0.5, -0.4), vec2(0.6, 0.4), 0.3)]
float sd2OrientedBox(vec2 p, vec2 a, vec2 b, float halfWidth) {
    float size = length(b - a);
    vec2 along = (b - a) / size;
    vec2 q = p - 0.5 * (a + b);
    return sd2Box(vec2(dot(q, along), along.x * q.y - along.y * q.x), vec2(0.5 * size, halfWidth));
}

// One edge of a polygon. Begin with state = vec2(1.0e9, 1.0), take the edges one after the other
// with the state before, and end with sd2PolygonEnd.
// Source: the state is the squared distance, and a sign that changes with each edge that a ray in
// the direction of +x crosses.
// example[sd2PolygonEnd(sd2PolygonEdge(p, vec2(-0.7, 0.5), vec2(-0.6, -0.6), sd2PolygonEdge(p, vec2(0.0, -0.1), vec2(-0.7, 0.5), sd2PolygonEdge(p, vec2(0.7, 0.6), vec2(0.0, -0.1), sd2PolygonEdge(p, vec2(-0.6, -0.6), vec2(0.7, 0.6), vec2(1.0e9, 1.0))))))]
vec2 sd2PolygonEdge(vec2 p, vec2 a, vec2 b, vec2 state) {
    vec2 along = b - a;
    vec2 q = p - a;
    vec2 away = q - along * clamp(dot(q, along) / dot(along, along), 0.0, 1.0);
    bool rises = p.y >= a.y && p.y < b.y;
    bool falls = p.y >= b.y && p.y < a.y;
    float left = along.x * q.y - along.y * q.x;
    bool crossed = (rises && left > 0.0) || (falls && left < 0.0);
    return vec2(min(state.x, dot(away, away)), crossed ? -state.y : state.y);
}

// The distance, from the state after the last edge.
// exact
// example[sd2PolygonEnd(sd2PolygonEdge(p, vec2(0.0, 0.7), vec2(-0.7, -0.5), sd2PolygonEdge(p, vec2(0.8, -0.2), vec2(0.0, 0.7), sd2PolygonEdge(p, vec2(-0.7, -0.5), vec2(0.8, -0.2), vec2(1.0e9, 1.0)))))]
float sd2PolygonEnd(vec2 state) {
    return state.y * sqrt(state.x);
}

// A triangle, its corners in any order.
// exact
// bounds[min(a, min(b, c)), max(a, max(b, c))]
// example[sd2Triangle(p, vec2(-0.7, -0.5), vec2(0.8, -0.2), vec2(0.1, 0.7))]
float sd2Triangle(vec2 p, vec2 a, vec2 b, vec2 c) {
    vec2 state = sd2PolygonEdge(p, a, b, vec2(1.0e9, 1.0));
    return sd2PolygonEnd(sd2PolygonEdge(p, c, a, sd2PolygonEdge(p, b, c, state)));
}

// A polygon of four corners, convex or not, which do not cross.
// exact
// bounds[min(min(a, b), min(c, d)), max(max(a, b), max(c, d))]
// example[sd2Quad(p, vec2(-0.7, -0.5), vec2(0.8, -0.3), vec2(0.3, 0.0), vec2(0.4, 0.7))]
float sd2Quad(vec2 p, vec2 a, vec2 b, vec2 c, vec2 d) {
    vec2 state = sd2PolygonEdge(p, b, c, sd2PolygonEdge(p, a, b, vec2(1.0e9, 1.0)));
    return sd2PolygonEnd(sd2PolygonEdge(p, d, a, sd2PolygonEdge(p, c, d, state)));
}

// A trapezoid around the y axis: half its widths below and above.
// Source: mirrored in the axis, three edges are left.
// exact
// bounds[vec2(-max(bottom, top), -halfHeight), vec2(max(bottom, top), halfHeight)]
// example[sd2Trapezoid(p, 0.8, 0.4, 0.5)]
// example[sd2Trapezoid(p, 0.0, 0.7, 0.6)]
float sd2Trapezoid(vec2 p, float bottom, float top, float halfHeight) {
    vec2 q = vec2(abs(p.x), p.y);
    vec2 side = vec2(top - bottom, 2.0 * halfHeight);
    vec2 corner = q - vec2(bottom, -halfHeight);
    vec2 away = corner - side * clamp(dot(corner, side) / dot(side, side), 0.0, 1.0);
    // Above or below: the edge that is nearer in y, as wide as it is.
    vec2 flat2 = vec2(max(q.x - (q.y < 0.0 ? bottom : top), 0.0), abs(q.y) - halfHeight);
    float outside = sqrt(min(dot(away, away), dot(flat2, flat2)));
    bool within = side.x * corner.y - side.y * corner.x > 0.0 && flat2.y < 0.0;
    return within ? -outside : outside;
}

// An isosceles triangle: base at y = 0, tip at (0, height).
// exact
// bounds[vec2(-halfBase, 0.0), vec2(halfBase, height)]
// example[sd2Isosceles(p + vec2(0.0, 0.5), 0.6, 1.1)]
float sd2Isosceles(vec2 p, float halfBase, float height) {
    return sd2Trapezoid(p - vec2(0.0, 0.5 * height), halfBase, 0.0, 0.5 * height);
}

// A parallelogram: its upper edge is moved to the right by `skew`, its lower edge to the left.
// Source: point symmetry leaves the upper and the right edge.
// exact
// bounds[vec2(-halfWidth - abs(skew), -halfHeight), vec2(halfWidth + abs(skew), halfHeight)]
// example[sd2Parallelogram(p, 0.5, 0.5, 0.3)]
float sd2Parallelogram(vec2 p, float halfWidth, float halfHeight, float skew) {
    vec2 a = vec2(skew - halfWidth, halfHeight);
    vec2 b = vec2(skew + halfWidth, halfHeight);
    return sd2Quad(p, a, b, -a, -b);
}

// A rhombus with its corners on the axes.
// Source: mirrored in both axes, one edge is left.
// exact
// bounds[-halfSize, halfSize]
// example[sd2Rhombus(p, vec2(0.8, 0.5))]
float sd2Rhombus(vec2 p, vec2 halfSize) {
    vec2 q = abs(p);
    float away = sd2Segment(q, vec2(halfSize.x, 0.0), vec2(0.0, halfSize.y));
    return q.x * halfSize.y + q.y * halfSize.x < halfSize.x * halfSize.y ? -away : away;
}

// A rectangle whose corners are cut off at 45 degrees, `cut` along each side.
// Source: mirrored in both axes and, outside, the nearest of three edges.
// exact
// bounds[-halfSize, halfSize]
// example[sd2ChamferBox(p, vec2(0.8, 0.5), 0.2)]
float sd2ChamferBox(vec2 p, vec2 halfSize, float cut) {
    vec2 q = abs(p);
    vec2 a = vec2(halfSize.x, halfSize.y - cut);
    vec2 b = vec2(halfSize.x - cut, halfSize.y);
    float corner = sd2Segment(q, a, b);
    float right = length(vec2(q.x - a.x, max(q.y - a.y, 0.0)));
    float top = length(vec2(max(q.x - b.x, 0.0), q.y - b.y));
    bool within = q.x < a.x && q.y < b.y && q.x + q.y < a.x + a.y;
    float away = min(corner, min(right, top));
    return within ? -away : away;
}

// A regular polygon of `count` edges, one of them below; `radius` goes to the middle of an edge.
// Source: turned into the sector of one edge, which is then mirrored, half an edge is left.
// exact
// bounds[vec2(-radius / cos(3.14159265359 / count)), vec2(radius / cos(3.14159265359 / count))]
// example[sd2Polygon(p, 5.0, 0.6)]
// example[sd2Polygon(p, 3.0, 0.4)]
float sd2Polygon(vec2 p, float count, float radius) {
    float sector = 6.28318530718 / count;
    float angle = atan(p.x, -p.y);
    angle = abs(angle - sector * round(angle / sector));
    vec2 q = length(p) * vec2(sin(angle), cos(angle));
    float beyond = max(q.x - radius * tan(0.5 * sector), 0.0);
    float away = q.y - radius;
    return beyond > 0.0 ? length(vec2(beyond, away)) : away;
}

// A star with `count` points, one of them above: `outer` to the points, `inner` to the notches.
// Source: as for sd2Polygon, with the edge from a point to a notch.
// exact
// bounds[vec2(-outer), vec2(outer)]
// example[sd2Star(p, 5.0, 0.9, 0.4)]
// example[sd2Star(p, 6.0, 0.9, 0.519615242)]
float sd2Star(vec2 p, float count, float outer, float inner) {
    float sector = 6.28318530718 / count;
    float angle = atan(p.x, p.y);
    angle = abs(angle - sector * round(angle / sector));
    vec2 q = length(p) * vec2(sin(angle), cos(angle));
    vec2 tip = vec2(0.0, outer);
    vec2 notch = inner * vec2(sin(0.5 * sector), cos(0.5 * sector));
    vec2 edge = notch - tip;
    bool within = edge.x * (q.y - tip.y) - edge.y * q.x < 0.0;
    float away = sd2Segment(q, tip, notch);
    return within ? -away : away;
}

// A plus sign: bars of half length `reach` and half width `halfWidth`.
// Source: mirrored thrice, one bar is left; the notch is the nearest only from inside.
// exact
// bounds[vec2(-reach), vec2(reach)]
// example[sd2Cross(p, 0.8, 0.25)]
float sd2Cross(vec2 p, float reach, float halfWidth) {
    vec2 q = abs(p);
    q = vec2(max(q.x, q.y), min(q.x, q.y));
    vec2 d = q - vec2(reach, halfWidth);
    float outside = length(max(d, 0.0));
    float notch = length(q - halfWidth);
    float inside = min(-d.x, q.x > halfWidth ? -d.y : notch);
    return max(d.x, d.y) > 0.0 ? outside : -inside;
}

// An X of two round strokes of half width `halfWidth`, which end at (+-reach, +-reach).
// exact outside
// lipschitz[1.0]
// bounds[vec2(-reach - halfWidth), vec2(reach + halfWidth)]
// example[sd2RoundedX(p, 0.6, 0.15)]
float sd2RoundedX(vec2 p, float reach, float halfWidth) {
    vec2 q = abs(p);
    return length(q - min(0.5 * (q.x + q.y), reach)) - halfWidth;
}

// Stairs of `count` steps that rise to the right, of `width` and `height` each, on the ground y = 0.
// Source: the corners of the steps lie on a line; the step that the foot on it belongs to, and its
// two neighbours, hold the nearest edge.
// exact
// bounds[vec2(0.0), vec2(count * width, count * height)]
// example[sd2Stairs(p + vec2(0.8, 0.6), 5.0, 0.3, 0.22)]
float sd2Stairs(vec2 p, float count, float width, float height) {
    vec2 slope = vec2(width, height);
    float nearest = round(dot(p, slope) / dot(slope, slope) - 0.5);
    float away = 1.0e9;
    for (int i = -1; i <= 1; i++) {
        float n = clamp(nearest + float(i), 0.0, count - 1.0);
        vec2 low = vec2(n * width, n * height);
        away = min(away, sd2Segment(p, low, low + vec2(0.0, height)));
        away = min(away, sd2Segment(p, low + vec2(0.0, height), low + slope));
    }
    vec2 end = vec2(count * width, count * height);
    away = min(away, sd2Segment(p, vec2(0.0), vec2(end.x, 0.0)));
    away = min(away, sd2Segment(p, vec2(end.x, 0.0), end));
    bool within = p.x > 0.0 && p.x < end.x && p.y > 0.0 && p.y < height * ceil(p.x / width);
    return within ? -away : away;
}
