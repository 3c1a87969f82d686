// SPDX-License-Identifier: MIT
// Plane shapes with curved edges, to extrude (opExtrude) or revolve (domRevolve); y points up.
// Arcs: a point sees the arc itself where its direction from the middle lies between the arc's
// ends, else the nearer end.

// A disc.
// exact
// bounds[vec2(-radius), vec2(radius)]
// example[sd2Circle(p, 0.7)]
float sd2Circle(vec2 p, float radius) {
    return length(p) - radius;
}

// A ring; `radius` goes to the middle of its band.
// exact
// bounds[vec2(-radius - halfWidth), vec2(radius + halfWidth)]
// example[sd2Ring(p, 0.6, 0.15)]
float sd2Ring(vec2 p, float radius, float halfWidth) {
    return abs(length(p) - radius) - halfWidth;
}

// A stroke with round ends along an arc, which is `halfAngle` (radians) long to both sides of +y.
// exact
// bounds[vec2(-radius - halfWidth), vec2(radius + halfWidth)]
// example[sd2Arc(p, 2.0, 0.6, 0.12)]
float sd2Arc(vec2 p, float halfAngle, float radius, float halfWidth) {
    vec2 q = vec2(abs(p.x), p.y);
    vec2 end = vec2(sin(halfAngle), cos(halfAngle));
    bool seesArc = q.x * end.y < q.y * end.x;
    return (seesArc ? abs(length(q) - radius) : length(q - radius * end)) - halfWidth;
}

// A piece of pie: the part of a disc within `halfAngle` (radians) of +y.
// exact
// bounds[vec2(-radius), vec2(radius)]
// example[sd2Pie(p, 0.8, 0.8)]
// example[sd2Pie(p, 2.4, 0.8)]
float sd2Pie(vec2 p, float halfAngle, float radius) {
    vec2 q = vec2(abs(p.x), p.y);
    vec2 end = vec2(sin(halfAngle), cos(halfAngle));
    float edge = length(q - end * clamp(dot(q, end), 0.0, radius));
    bool seesArc = q.x * end.y < q.y * end.x;
    return seesArc ? max(length(q) - radius, -edge) : edge;
}

// The part of a disc above y = cut.
// exact
// bounds[vec2(-radius, cut), vec2(radius)]
// example[sd2CutDisc(p, 0.8, -0.3)]
// example[sd2CutDisc(p, 0.8, 0.3)]
float sd2CutDisc(vec2 p, float radius, float cut) {
    vec2 q = vec2(abs(p.x), p.y);
    vec2 corner = vec2(sqrt(max(radius * radius - cut * cut, 0.0)), cut);
    float fromMiddle = length(q) - radius;
    float away = length(vec2(max(q.x - corner.x, 0.0), q.y - cut));
    if (q.x * corner.y < q.y * corner.x) away = min(away, abs(fromMiddle));
    return fromMiddle < 0.0 && q.y > cut ? -away : away;
}

// A lens: what two discs share, whose middles stand at (+-offset, 0).
// Source: beside the tips an arc is the nearest, else the tip.
// exact
// bounds[vec2(offset - radius, -sqrt(radius * radius - offset * offset)), vec2(radius - offset, sqrt(radius * radius - offset * offset))]
// example[sd2Vesica(p, 1.0, 0.5)]
float sd2Vesica(vec2 p, float radius, float offset) {
    vec2 q = abs(p);
    float tip = sqrt(max(radius * radius - offset * offset, 0.0));
    bool seesTip = offset * (q.y - tip) > tip * q.x;
    return seesTip ? length(q - vec2(0.0, tip)) : length(q + vec2(offset, 0.0)) - radius;
}

// A moon: a disc without another, whose edge crosses its own and whose middle stands at (offset, 0).
// exact
// bounds[vec2(-radius), vec2(radius)]
// example[sd2Moon(p, 0.8, 0.65, 0.4)]
float sd2Moon(vec2 p, float radius, float biteRadius, float offset) {
    vec2 q = vec2(p.x, abs(p.y));
    vec2 u = q - vec2(offset, 0.0);
    float x = (radius * radius - biteRadius * biteRadius + offset * offset) / (2.0 * offset);
    vec2 corner = vec2(x, sqrt(max(radius * radius - x * x, 0.0)));
    vec2 v = corner - vec2(offset, 0.0);
    float outer = length(q) - radius;
    float bite = length(u) - biteRadius;
    float away = length(q - corner);
    if (q.y * corner.x > q.x * corner.y) away = min(away, abs(outer));
    if (u.y * v.x > u.x * v.y) away = min(away, abs(bite));
    return outer < 0.0 && bite > 0.0 ? -away : away;
}

// The hull of two discs: one about the origin, one about (0, height). |bottom - top| < height.
// Source: along the common tangent the distance grows straight away from it; its normal has the
// sine (bottom - top) / height.
// exact
// bounds[vec2(-max(bottom, top), -bottom), vec2(max(bottom, top), height + top)]
// example[sd2Drop(p + vec2(0.0, 0.3), 0.45, 0.2, 0.7)]
float sd2Drop(vec2 p, float bottom, float top, float height) {
    vec2 q = vec2(abs(p.x), p.y);
    float s = (bottom - top) / height;
    float c = sqrt(max(1.0 - s * s, 0.0));
    float along = c * q.y - s * q.x;
    if (along < 0.0) return length(q) - bottom;
    if (along > c * height) return length(q - vec2(0.0, height)) - top;
    return c * q.x + s * q.y - bottom;
}

// An egg: half a disc of `bottom` below y = 0, a cap of `top` above, joined by arcs that are
// tangent to both. top < bottom.
// Source: an arc from the level end of the half disc has its middle on y = 0, at (-m, 0), and the
// radius bottom + m; it touches the cap, whose middle stands at (0, h), from within:
// sqrt(m^2 + h^2) = bottom + m - top. Here h = bottom - top + `stretch`.
// exact
// bounds[vec2(-bottom, -bottom), vec2(bottom, bottom + stretch)]
// example[sd2Egg(p + vec2(0.0, 0.15), 0.6, 0.25, 0.35)]
float sd2Egg(vec2 p, float bottom, float top, float stretch) {
    vec2 q = vec2(abs(p.x), p.y);
    float k = bottom - top;
    float h = k + stretch;
    float m = (h * h - k * k) / (2.0 * k);
    if (q.y < 0.0) return length(q) - bottom;
    // The arc ends where the line from its middle through the cap's middle leads.
    if (h * (q.x + m) < m * q.y) return length(q - vec2(0.0, h)) - top;
    return length(q + vec2(m, 0.0)) - bottom - m;
}

// A heart with its tip at the origin, of `size` from there to the notch.
// Source: a square that stands on its tip, with half discs on its upper edges.
// exact
// bounds[size * vec2(-0.6035534, 0.0), size * vec2(0.6035534, 1.1035534)]
// example[sd2Heart(p + vec2(0.0, 0.7), 1.3)]
float sd2Heart(vec2 p, float size) {
    vec2 q = vec2(abs(p.x), p.y) / size;
    float radius = 0.35355339059;
    vec2 u = q - vec2(0.25, 0.75);
    float arc = length(u) - radius;
    float away = min(length(q - vec2(0.0, 1.0)), sd2Segment(q, vec2(0.0), vec2(0.5)));
    if (u.x + u.y > 0.0) away = min(away, abs(arc));
    bool within = q.x + abs(q.y - 0.5) < 0.5 || arc < 0.0;
    return size * (within ? -away : away);
}

// A horseshoe: an arc, open to +y, with straight ends of `legs`. `halfAngle` (radians) is that of
// the opening; the ends do not reach across the middle.
// Source: a half plane through the middle parts the points that see the arc from those that see the
// leg; the bar's end between the two is no edge.
// exact
// bounds[vec2(-radius - halfWidth - legs), vec2(radius + halfWidth + legs)]
// example[sd2Horseshoe(p + vec2(0.0, 0.1), 0.6, 0.6, 0.12, 0.25)]
float sd2Horseshoe(vec2 p, float halfAngle, float radius, float halfWidth, float legs) {
    vec2 q = vec2(abs(p.x), p.y);
    vec2 end = vec2(sin(halfAngle), cos(halfAngle));
    float along = end.x * q.y - end.y * q.x;
    if (along < 0.0) return abs(length(q) - radius) - halfWidth;
    vec2 leg = vec2(abs(dot(q, end) - radius) - halfWidth, along - legs);
    return length(max(leg, 0.0)) + min(max(leg.x, leg.y), 0.0);
}

// A tunnel or window: a rectangle with half a disc on top; the disc's middle stands at the origin.
// exact
// bounds[vec2(-halfWidth, -height), vec2(halfWidth)]
// example[sd2Tunnel(p, 0.5, 0.6)]
float sd2Tunnel(vec2 p, float halfWidth, float height) {
    vec2 q = vec2(abs(p.x), p.y);
    if (q.y > 0.0) {
        float roof = length(q) - halfWidth;
        return roof > 0.0 ? roof : max(roof, -q.y - height);
    }
    vec2 d = vec2(q.x - halfWidth, -q.y - height);
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}

// What is left of a cross between four discs: a square with hollow sides, its corners on the axes at
// `reach`; the discs' middles stand at (+-middle, +-middle), middle >= reach.
// Source: mirrored in both axes, one arc is left, seen unless a corner is nearer.
// exact
// bounds[vec2(-reach), vec2(reach)]
// example[sd2HollowSquare(p, 0.8, 0.9)]
float sd2HollowSquare(vec2 p, float reach, float middle) {
    vec2 q = abs(p);
    q = vec2(max(q.x, q.y), min(q.x, q.y));
    vec2 corner = vec2(reach, 0.0);
    vec2 u = q - middle;
    vec2 v = corner - middle;
    float arc = length(v) - length(u);
    float away = length(q - corner);
    // Both in the half below the diagonal: between the corner's direction and the diagonal's.
    if (v.x * u.y - v.y * u.x < 0.0 && u.x + u.y < 0.0) away = min(away, abs(arc));
    bool within = arc < 0.0 && q.x < reach && q.x + q.y < 2.0 * middle;
    return within ? -away : away;
}

// A wave of arcs along x with half a period of 2 sin(halfAngle) radius; `halfAngle` (radians, below
// pi / 2) is half of an arc. No inside; subtract half a width.
// Source: each arc goes through the origin's level; turned half around, all arcs are one.
// exact
// example[sd2CircleWave(p, 1.1, 0.3) - 0.06]
float sd2CircleWave(vec2 p, float halfAngle, float radius) {
    vec2 end = radius * vec2(sin(halfAngle), cos(halfAngle));
    float halfPeriod = 2.0 * end.x;
    float number = round(p.x / halfPeriod);
    float away = 1.0e9;
    for (int i = -1; i <= 1; i++) {
        float n = number + float(i);
        float turn = 1.0 - 2.0 * abs(n - 2.0 * round(0.5 * n));
        vec2 q = vec2(abs(p.x - n * halfPeriod), turn * p.y + end.y);
        bool seesArc = q.x * end.y < q.y * end.x;
        away = min(away, seesArc ? abs(length(q) - radius) : length(q - end));
    }
    return away;
}
