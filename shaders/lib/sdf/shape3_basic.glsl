// SPDX-License-Identifier: MIT
// Solids with flat or round faces. The axis of whatever has one is y; half heights, so that the
// middle is the origin; angles in radians.

// A ball.
// exact
// bounds[vec3(-radius), vec3(radius)]
// example[sdSphere(p, 0.7)]
float sdSphere(vec3 p, float radius) {
    return length(p) - radius;
}

// All behind the plane dot(p, normal) = offset; `normal` has length 1.
// exact
// example[sdPlane(p, vec3(0.0, 0.8, 0.6), 0.1)]
float sdPlane(vec3 p, vec3 normal, float offset) {
    return dot(p, normal) - offset;
}

// The eighth of space where no coordinate is positive.
// exact
// example[sdCorner(p)]
float sdCorner(vec3 p) {
    return length(max(p, 0.0)) + min(max(p.x, max(p.y, p.z)), 0.0);
}

// A box.
// Source: outside, the part of the point that is beyond the faces; inside, the nearest face.
// exact
// bounds[-halfSize, halfSize]
// example[sdBox(p, vec3(0.7, 0.4, 0.5))]
float sdBox(vec3 p, vec3 halfSize) {
    return sdCorner(abs(p) - halfSize);
}

// A box with round edges; `halfSize` includes them.
// exact
// bounds[-halfSize, halfSize]
// example[sdRoundedBox(p, vec3(0.7, 0.4, 0.5), 0.15)]
float sdRoundedBox(vec3 p, vec3 halfSize, float radius) {
    return sdBox(p, halfSize - radius) - radius;
}

// The twelve edges of a box, as bars `bar` thick.
// Source: mirrored in three planes, three bars are left, which end in one corner.
// exact outside
// lipschitz[1.0]
// bounds[-halfSize, halfSize]
// example[sdBoxFrame(p, vec3(0.7, 0.5, 0.6), 0.1)]
float sdBoxFrame(vec3 p, vec3 halfSize, float bar) {
    vec3 q = abs(p) - halfSize;
    vec3 across = abs(q + 0.5 * bar) - 0.5 * bar;
    float alongX = sdCorner(vec3(q.x, across.y, across.z));
    float alongY = sdCorner(vec3(across.x, q.y, across.z));
    return min(min(alongX, alongY), sdCorner(vec3(across.x, across.y, q.z)));
}

// A torus around the y axis: `ring` is the radius of its middle line, `tube` that of its tube.
// Source: in the half plane through the axis it is a disc.
// exact
// bounds[vec3(-ring - tube, -tube, -ring - tube), vec3(ring + tube, tube, ring + tube)]
// example[sdTorus(p, 0.6, 0.22)]
float sdTorus(vec3 p, float ring, float tube) {
    return length(vec2(length(p.xz) - ring, p.y)) - tube;
}

// Part of a torus around the y axis, with round ends: `halfAngle` to both sides of +z.
// Source: the middle line is an arc in the plane y = 0.
// exact
// bounds[vec3(-ring - tube, -tube, -ring - tube), vec3(ring + tube, tube, ring + tube)]
// example[sdCappedTorus(p, 2.2, 0.6, 0.18)]
float sdCappedTorus(vec3 p, float halfAngle, float ring, float tube) {
    return length(vec2(sd2Arc(p.xz, halfAngle, ring, 0.0), p.y)) - tube;
}

// A link of a chain, long along y: two half tori of radius `ring`, 2 `halfLength` apart.
// Source: the nearest point of the middle line is on the straight pieces wherever those are level
// with the point.
// exact
// bounds[vec3(-ring - tube, -ring - tube - halfLength, -tube), vec3(ring + tube, ring + tube + halfLength, tube)]
// example[sdLink(p, 0.3, 0.35, 0.14)]
float sdLink(vec3 p, float halfLength, float ring, float tube) {
    vec2 q = vec2(p.x, max(abs(p.y) - halfLength, 0.0));
    return length(vec2(length(q) - ring, p.z)) - tube;
}

// A cylinder without ends.
// exact
// example[sdCylinderInfinite(p, 0.5)]
float sdCylinderInfinite(vec3 p, float radius) {
    return length(p.xz) - radius;
}

// A cylinder.
// exact
// bounds[vec3(-radius, -halfHeight, -radius), vec3(radius, halfHeight, radius)]
// example[sdCylinder(p, 0.5, 0.6)]
float sdCylinder(vec3 p, float radius, float halfHeight) {
    return sd2Box(vec2(length(p.xz), p.y), vec2(radius, halfHeight));
}

// A cylinder with round edges; the sizes include them.
// exact
// bounds[vec3(-radius, -halfHeight, -radius), vec3(radius, halfHeight, radius)]
// example[sdRoundedCylinder(p, 0.6, 0.5, 0.15)]
float sdRoundedCylinder(vec3 p, float radius, float halfHeight, float edge) {
    return sd2RoundedBox(vec2(length(p.xz), p.y), vec2(radius, halfHeight), edge);
}

// A cylinder whose ends have their middles at a and b.
// exact
// bounds[min(a, b) - radius, max(a, b) + radius]
// example[sdCylinderBetween(p, vec3(-0.5, -0.4, 0.1), vec3(0.5, 0.4, -0.1), 0.35)]
float sdCylinderBetween(vec3 p, vec3 a, vec3 b, float radius) {
    float size = length(b - a);
    vec3 axis = (b - a) / size;
    vec3 q = p - 0.5 * (a + b);
    float along = dot(q, axis);
    return sd2Box(vec2(length(q - along * axis), along), vec2(radius, 0.5 * size));
}

// A piece of pipe; `radius` goes to the middle of its wall.
// exact
// bounds[vec3(-radius - halfThickness, -halfHeight, -radius - halfThickness), vec3(radius + halfThickness, halfHeight, radius + halfThickness)]
// example[sdTube(p, 0.55, 0.08, 0.5)]
float sdTube(vec3 p, float radius, float halfThickness, float halfHeight) {
    return sd2Box(vec2(length(p.xz) - radius, p.y), vec2(halfThickness, halfHeight));
}

// A disc, `halfThickness` thick to both sides and around its rim.
// exact
// bounds[vec3(-radius - halfThickness, -halfThickness, -radius - halfThickness), vec3(radius + halfThickness, halfThickness, radius + halfThickness)]
// example[sdDisc(p, 0.7, 0.05)]
float sdDisc(vec3 p, float radius, float halfThickness) {
    return length(vec2(max(length(p.xz) - radius, 0.0), p.y)) - halfThickness;
}

// A capsule: all within `radius` of the line from a to b.
// exact
// bounds[min(a, b) - radius, max(a, b) + radius]
// example[sdCapsule(p, vec3(-0.5, -0.3, 0.1), vec3(0.5, 0.3, -0.1), 0.3)]
float sdCapsule(vec3 p, vec3 a, vec3 b, float radius) {
    vec3 along = b - a;
    vec3 q = p - a;
    return length(q - along * clamp(dot(q, along) / dot(along, along), 0.0, 1.0)) - radius;
}

// A capsule around the y axis; `halfHeight` goes to the middles of its ends.
// exact
// bounds[vec3(-radius, -radius - halfHeight, -radius), vec3(radius, radius + halfHeight, radius)]
// example[sdCapsuleY(p, 0.4, 0.35)]
float sdCapsuleY(vec3 p, float halfHeight, float radius) {
    return length(vec3(p.x, max(abs(p.y) - halfHeight, 0.0), p.z)) - radius;
}

// A cone with its base at y = 0 and its tip at (0, height, 0).
// exact
// bounds[vec3(-radius, 0.0, -radius), vec3(radius, height, radius)]
// example[sdCone(p + vec3(0.0, 0.5, 0.0), 0.6, 1.1)]
float sdCone(vec3 p, float radius, float height) {
    return sd2Isosceles(vec2(length(p.xz), p.y), radius, height);
}

// A cone without end: tip at the origin, open downwards, `halfAngle` between axis and side.
// exact
// example[sdConeInfinite(p - vec3(0.0, 0.6, 0.0), 0.5)]
float sdConeInfinite(vec3 p, float halfAngle) {
    vec2 q = vec2(length(p.xz), -p.y);
    vec2 side = vec2(sin(halfAngle), cos(halfAngle));
    float away = length(q - side * max(dot(q, side), 0.0));
    return q.x * side.y < q.y * side.x ? -away : away;
}

// A cone without its tip: radii below and above.
// exact
// bounds[vec3(-max(bottom, top), -halfHeight, -max(bottom, top)), vec3(max(bottom, top), halfHeight, max(bottom, top))]
// example[sdCappedCone(p, 0.7, 0.35, 0.5)]
float sdCappedCone(vec3 p, float bottom, float top, float halfHeight) {
    return sd2Trapezoid(vec2(length(p.xz), p.y), bottom, top, halfHeight);
}

// A cone without its tip whose ends have their middles at a and b.
// exact
// bounds[min(a - radiusA, b - radiusB), max(a + radiusA, b + radiusB)]
// example[sdCappedConeBetween(p, vec3(-0.5, -0.3, 0.1), vec3(0.5, 0.4, -0.1), 0.5, 0.2)]
float sdCappedConeBetween(vec3 p, vec3 a, vec3 b, float radiusA, float radiusB) {
    float size = length(b - a);
    vec3 axis = (b - a) / size;
    vec3 q = p - 0.5 * (a + b);
    float along = dot(q, axis);
    return sd2Trapezoid(vec2(length(q - along * axis), along), radiusA, radiusB, 0.5 * size);
}

// The hull of two balls: one about the origin, one about (0, height, 0). |bottom - top| < height.
// exact
// bounds[vec3(-max(bottom, top), -bottom, -max(bottom, top)), vec3(max(bottom, top), height + top, max(bottom, top))]
// example[sdRoundCone(p + vec3(0.0, 0.3, 0.0), 0.45, 0.2, 0.7)]
float sdRoundCone(vec3 p, float bottom, float top, float height) {
    return sd2Drop(vec2(length(p.xz), p.y), bottom, top, height);
}

// The hull of two balls about a and b.
// exact
// bounds[min(a - radiusA, b - radiusB), max(a + radiusA, b + radiusB)]
// example[sdRoundConeBetween(p, vec3(-0.4, -0.3, 0.1), vec3(0.5, 0.4, -0.1), 0.4, 0.2)]
float sdRoundConeBetween(vec3 p, vec3 a, vec3 b, float radiusA, float radiusB) {
    float size = length(b - a);
    vec3 axis = (b - a) / size;
    float along = dot(p - a, axis);
    return sd2Drop(vec2(length(p - a - along * axis), along), radiusA, radiusB, size);
}

// The part of a ball within `halfAngle` of +y.
// exact
// bounds[vec3(-radius), vec3(radius)]
// example[sdSolidAngle(p + vec3(0.0, 0.4, 0.0), 0.6, 1.0)]
float sdSolidAngle(vec3 p, float halfAngle, float radius) {
    return sd2Pie(vec2(length(p.xz), p.y), halfAngle, radius);
}

// The part of a ball above y = cut.
// exact
// bounds[vec3(-radius, cut, -radius), vec3(radius)]
// example[sdCutSphere(p, 0.8, -0.2)]
float sdCutSphere(vec3 p, float radius, float cut) {
    return sd2CutDisc(vec2(length(p.xz), p.y), radius, cut);
}

// A bowl: the skin of a ball below y = cut, with a round rim.
// exact
// bounds[vec3(-radius - halfThickness), vec3(radius + halfThickness, max(cut, -radius) + halfThickness, radius + halfThickness)]
// example[sdCutHollowSphere(p, 0.75, 0.2, 0.05)]
float sdCutHollowSphere(vec3 p, float radius, float cut, float halfThickness) {
    float halfAngle = acos(clamp(-cut / radius, -1.0, 1.0));
    return sd2Arc(vec2(length(p.xz), -p.y), halfAngle, radius, halfThickness);
}

// A ball with a round bite out of its upper side; the bite's middle stands at (0, offset, 0) and its
// surface crosses the ball's.
// exact
// bounds[vec3(-radius), vec3(radius)]
// example[sdDeathStar(p, 0.7, 0.5, 0.75)]
float sdDeathStar(vec3 p, float radius, float biteRadius, float offset) {
    return sd2Moon(vec2(p.y, length(p.xz)), radius, biteRadius, offset);
}

// A spindle around the y axis: a lens of two arcs, revolved about the line through its tips. The
// arcs have `radius`, their middles stand `offset` beside the axis.
// exact
// bounds[vec3(offset - radius, -sqrt(radius * radius - offset * offset), offset - radius), vec3(radius - offset, sqrt(radius * radius - offset * offset), radius - offset)]
// example[sdVesica(p, 1.0, 0.55)]
float sdVesica(vec3 p, float radius, float offset) {
    return sd2Vesica(vec2(length(p.xz), p.y), radius, offset);
}

// A spindle with its tips at a and b, `halfWidth` thick in the middle.
// Source: an arc through a tip that is halfWidth away from the axis in the middle.
// exact
// bounds[min(a, b) - halfWidth, max(a, b) + halfWidth]
// example[sdVesicaBetween(p, vec3(-0.7, -0.4, 0.2), vec3(0.7, 0.4, -0.2), 0.35)]
float sdVesicaBetween(vec3 p, vec3 a, vec3 b, float halfWidth) {
    float tip = 0.5 * length(b - a);
    vec3 axis = 0.5 * (b - a) / tip;
    vec3 q = p - 0.5 * (a + b);
    float along = dot(q, axis);
    float offset = 0.5 * (tip * tip - halfWidth * halfWidth) / halfWidth;
    return sd2Vesica(vec2(length(q - along * axis), along), halfWidth + offset, offset);
}

// A lens: what two balls share, whose middles stand at (0, +-offset, 0).
// exact
// bounds[vec3(-sqrt(radius * radius - offset * offset), offset - radius, -sqrt(radius * radius - offset * offset)), vec3(sqrt(radius * radius - offset * offset), radius - offset, sqrt(radius * radius - offset * offset))]
// example[sdLens(p, 1.0, 0.65)]
float sdLens(vec3 p, float radius, float offset) {
    return sd2Vesica(vec2(p.y, length(p.xz)), radius, offset);
}

// An egg that stands on its round end; as sd2Egg.
// exact
// bounds[vec3(-bottom, -bottom, -bottom), vec3(bottom, bottom + stretch, bottom)]
// example[sdEgg(p + vec3(0.0, 0.15, 0.0), 0.6, 0.25, 0.35)]
float sdEgg(vec3 p, float bottom, float top, float stretch) {
    return sd2Egg(vec2(length(p.xz), p.y), bottom, top, stretch);
}
