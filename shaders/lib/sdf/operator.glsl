// SPDX-License-Identifier: MIT
// Shapes put together and changed: op... takes distances and returns a distance. The slope given
// is the factor by which the result can be steeper than the steepest operand.
// In each family the difference a without b is the intersection of a with -b, and the intersection
// is the union turned inside out: -union(-a, -b).

// Both shapes.
// Source: the nearest of all points is in one or the other.
// exact outside
// lipschitz[1.0]
// example[opUnion(sdSphere(p - vec3(-0.25, 0.1, 0.0), 0.55), sdBox(p - vec3(0.35, -0.1, 0.0), vec3(0.4)))]
float opUnion(float a, float b) {
    return min(a, b);
}

// What the shapes share.
// exact inside
// lipschitz[1.0]
// example[opIntersection(sdSphere(p, 0.75), sdBox(p, vec3(0.58)))]
float opIntersection(float a, float b) {
    return max(a, b);
}

// The first shape without the second.
// bound
// lipschitz[1.0]
// example[opDifference(sdBox(p, vec3(0.6)), sdSphere(p - vec3(0.4, 0.4, 0.4), 0.5))]
float opDifference(float a, float b) {
    return max(a, -b);
}

// What lies in exactly one of the shapes.
// bound
// lipschitz[1.0]
// example[opXor(sdSphere(p - vec3(-0.25, 0.0, 0.0), 0.6), sdSphere(p - vec3(0.25, 0.0, 0.3), 0.6))]
float opXor(float a, float b) {
    return max(min(a, b), -max(a, b));
}

// Both of two (distance, part): that of the nearer.
// lipschitz[1.0]
// example[opUnionPart(vec2(sdSphere(p, 0.5), 0.0), vec2(sdTorus(p, 0.75, 0.12), 1.0)).x]
vec2 opUnionPart(vec2 a, vec2 b) {
    return a.x < b.x ? a : b;
}

// Union with a smooth seam where the distances differ by less than `width`; the seam is at most
// width / 4 thicker. Commutative, not associative.
// Source: min(a, b) is (a + b - |a - b|) / 2; the corner of |x| is replaced by the parabola that
// meets it with the same slope at |x| = width. The slopes are weighted by shares that add up to 1.
// bound
// lipschitz[1.0]
// example[opSmoothUnion(sdSphere(p - vec3(-0.3, 0.1, 0.0), 0.5), sdBox(p - vec3(0.4, -0.1, 0.0), vec3(0.35)), 0.4)]
float opSmoothUnion(float a, float b, float width) {
    float h = max(width - abs(a - b), 0.0);
    return min(a, b) - 0.25 * h * h / width;
}

// Intersection with a smooth edge, as opSmoothUnion.
// bound
// lipschitz[1.0]
// example[opSmoothIntersection(sdSphere(p, 0.75), sdBox(p, vec3(0.58)), 0.3)]
float opSmoothIntersection(float a, float b, float width) {
    return -opSmoothUnion(-a, -b, width);
}

// The first shape without the second, with a smooth edge, as opSmoothUnion.
// bound
// lipschitz[1.0]
// example[opSmoothDifference(sdBox(p, vec3(0.6)), sdSphere(p - vec3(0.4, 0.4, 0.4), 0.5), 0.3)]
float opSmoothDifference(float a, float b, float width) {
    return -opSmoothUnion(-a, b, width);
}

// As opSmoothUnion, with the share of b, from 0 to 1, for the mixing of materials:
// (distance, share).
// Source: the share is the weight of b's slope in the blend; 1/2 on the seam.
// lipschitz[1.0]
// example[opSmoothUnionBlend(sdSphere(p - vec3(-0.3, 0.1, 0.0), 0.5), sdBox(p - vec3(0.4, -0.1, 0.0), vec3(0.35)), 0.4).x]
vec2 opSmoothUnionBlend(float a, float b, float width) {
    return vec2(opSmoothUnion(a, b, width), clamp(0.5 + 0.5 * (a - b) / width, 0.0, 1.0));
}

// As opSmoothUnion for two (distance, part): the part of the nearer.
// lipschitz[1.0]
// example[opSmoothUnionPart(vec2(sdSphere(p, 0.5), 0.0), vec2(sdTorus(p, 0.6, 0.12), 1.0), 0.2).x]
vec2 opSmoothUnionPart(vec2 a, vec2 b, float width) {
    return vec2(opSmoothUnion(a.x, b.x, width), a.x < b.x ? a.y : b.y);
}

// As opSmoothUnion, but with a curvature that has no step at the ends of the seam: mirrors show no
// line there. At most width / 6 thicker. Commutative, not associative.
// Source: the corner of |x| replaced by |x| + (width - |x|)^3 / (3 width^2).
// bound
// lipschitz[1.0]
// example[opSmoothUnionCubic(sdSphere(p - vec3(-0.3, 0.1, 0.0), 0.5), sdBox(p - vec3(0.4, -0.1, 0.0), vec3(0.35)), 0.4)]
float opSmoothUnionCubic(float a, float b, float width) {
    float h = max(width - abs(a - b), 0.0) / width;
    return min(a, b) - width * h * h * h / 6.0;
}

// As opSmoothUnion, with a seam that is part of a circle where the shapes are planes; at most
// 0.3 width thicker. Commutative, not associative.
// Source: the corner of |x| replaced by the arc of radius sqrt(2) width about (0, 2 width), which
// meets it with slope 1 at |x| = width.
// bound
// lipschitz[1.0]
// example[opSmoothUnionCircular(sdSphere(p - vec3(-0.3, 0.1, 0.0), 0.5), sdBox(p - vec3(0.4, -0.1, 0.0), vec3(0.35)), 0.4)]
float opSmoothUnionCircular(float a, float b, float width) {
    float x = min(abs(a - b), width);
    float rise = 2.0 * width - sqrt(2.0 * width * width - x * x) - x;
    return min(a, b) - 0.5 * rise;
}

// A smooth union in which all shapes have a part everywhere; 0.69 `width` thicker on the seam of
// two. Commutative and associative, so that many shapes may be joined in any order.
// Source: log(exp(a) + exp(b)), with the larger term taken out so that nothing overflows.
// bound
// lipschitz[1.0]
// example[opSmoothUnionExponential(sdSphere(p - vec3(-0.3, 0.1, 0.0), 0.5), sdBox(p - vec3(0.4, -0.1, 0.0), vec3(0.35)), 0.08)]
float opSmoothUnionExponential(float a, float b, float width) {
    return min(a, b) - width * log(1.0 + exp(-abs(a - b) / width));
}

// Union with a hollow fillet of `radius` in the seam.
// Source: in the plane with coordinates (a, b), the arc of a circle about (radius, radius).
// bound
// lipschitz[1.41422]
// example[opRoundUnion(sdPlane(p, vec3(0.0, 1.0, 0.0), -0.3), sdBox(p, vec3(0.5, 0.7, 0.5)), 0.3)]
float opRoundUnion(float a, float b, float radius) {
    vec2 u = max(vec2(radius - a, radius - b), 0.0);
    return max(min(a, b), radius) - length(u);
}

// Intersection with an edge of `radius`.
// bound
// lipschitz[1.41422]
// example[opRoundIntersection(sdCylinder(p, 0.7, 0.5), sdBox(p, vec3(0.55)), 0.15)]
float opRoundIntersection(float a, float b, float radius) {
    return -opRoundUnion(-a, -b, radius);
}

// Difference with an edge of `radius`.
// bound
// lipschitz[1.41422]
// example[opRoundDifference(sdBox(p, vec3(0.6)), sdCylinderInfinite(p, 0.35), 0.15)]
float opRoundDifference(float a, float b, float radius) {
    return -opRoundUnion(-a, b, radius);
}

// Union with the seam filled at 45 degrees, `size` along both surfaces.
// Source: the line a + b = size in the plane (a, b).
// bound
// lipschitz[1.41422]
// example[opChamferUnion(sdPlane(p, vec3(0.0, 1.0, 0.0), -0.3), sdBox(p, vec3(0.5, 0.7, 0.5)), 0.2)]
float opChamferUnion(float a, float b, float size) {
    return min(min(a, b), (a + b - size) * 0.70710678119);
}

// Intersection with the edge cut at 45 degrees.
// bound
// lipschitz[1.41422]
// example[opChamferIntersection(sdCylinder(p, 0.7, 0.5), sdBox(p, vec3(0.6, 0.6, 0.6)), 0.1)]
float opChamferIntersection(float a, float b, float size) {
    return -opChamferUnion(-a, -b, size);
}

// Difference with the edge cut at 45 degrees.
// bound
// lipschitz[1.41422]
// example[opChamferDifference(sdBox(p, vec3(0.6)), sdCylinderInfinite(p, 0.35), 0.12)]
float opChamferDifference(float a, float b, float size) {
    return -opChamferUnion(-a, b, size);
}

// Union with `count` steps in the seam, `size` along both surfaces.
// Source: in the plane (a, b), the line through the steps' outer corners plus a triangle wave along
// it: on the wave's slopes one of the two distances cancels, which makes risers and treads.
// bound
// lipschitz[1.0]
// example[opStairsUnion(sdPlane(p, vec3(0.0, 1.0, 0.0), -0.4), sdBox(p, vec3(0.4, 0.7, 0.4)), 0.4, 4.0)]
float opStairsUnion(float a, float b, float size, float count) {
    float tread = size / count;
    float x = a - b - (size - tread);
    float wave = abs(x - 2.0 * tread * round(x / (2.0 * tread)));
    return min(min(a, b), 0.5 * (a + b - size - tread + wave));
}

// Intersection with steps along the edge.
// bound
// lipschitz[1.0]
// example[opStairsIntersection(sdCylinder(p, 0.7, 0.5), sdBox(p, vec3(0.6)), 0.25, 3.0)]
float opStairsIntersection(float a, float b, float size, float count) {
    return -opStairsUnion(-a, -b, size, count);
}

// Difference with steps along the edge.
// bound
// lipschitz[1.0]
// example[opStairsDifference(sdBox(p, vec3(0.6)), sdCylinderInfinite(p, 0.25), 0.3, 3.0)]
float opStairsDifference(float a, float b, float size, float count) {
    return -opStairsUnion(-a, b, size, count);
}

// Union with a row of `count` round columns in the seam, `size` along both surfaces.
// Source: in the plane (a, b), a chamfer with equal discs on its line.
// bound
// lipschitz[1.41422]
// example[opColumnsUnion(sdPlane(p, vec3(0.0, 1.0, 0.0), -0.4), sdBox(p, vec3(0.4, 0.7, 0.4)), 0.4, 3.0)]
float opColumnsUnion(float a, float b, float size, float count) {
    float width = size * 1.41421356237 / count;
    float across = (a + b - size) * 0.70710678119;
    float along = (a - b) * 0.70710678119 + 0.5 * width * (count - 1.0);
    along -= width * clamp(round(along / width), 0.0, count - 1.0);
    float row = min(across, length(vec2(across, along)) - 0.5 * width);
    return min(min(a, b), row);
}

// Intersection with grooves for round columns along the edge.
// bound
// lipschitz[1.41422]
// example[opColumnsIntersection(sdCylinder(p, 0.7, 0.5), sdBox(p, vec3(0.6)), 0.3, 3.0)]
float opColumnsIntersection(float a, float b, float size, float count) {
    return -opColumnsUnion(-a, -b, size, count);
}

// Difference with grooves for round columns along the edge.
// bound
// lipschitz[1.41422]
// example[opColumnsDifference(sdBox(p, vec3(0.6)), sdCylinderInfinite(p, 0.25), 0.3, 3.0)]
float opColumnsDifference(float a, float b, float size, float count) {
    return -opColumnsUnion(-a, b, size, count);
}

// A pipe of `radius` along the line where two surfaces meet.
// Source: the distance from the origin of the plane (a, b).
// bound
// lipschitz[1.41422]
// example[opPipe(sdSphere(p, 0.7), sdBox(p, vec3(0.55)), 0.08)]
float opPipe(float a, float b, float radius) {
    return length(vec2(a, b)) - radius;
}

// The first shape with a V-shaped groove of `depth` where the second's surface meets it.
// bound
// lipschitz[1.41422]
// example[opEngrave(sdSphere(p, 0.7), sdBox(p, vec3(0.45, 0.9, 0.45)), 0.1)]
float opEngrave(float a, float b, float depth) {
    return max(a, (a + depth - abs(b)) * 0.70710678119);
}

// The first shape with a groove of `depth` and `halfWidth` where the second's surface meets it.
// bound
// lipschitz[1.0]
// example[opGroove(sdSphere(p, 0.7), sdBox(p, vec3(0.45, 0.9, 0.45)), 0.1, 0.05)]
float opGroove(float a, float b, float depth, float halfWidth) {
    return max(a, min(a + depth, halfWidth - abs(b)));
}

// The first shape with a ridge of `height` and `halfWidth` where the second's surface meets it.
// bound
// lipschitz[1.0]
// example[opTongue(sdSphere(p, 0.7), sdBox(p, vec3(0.45, 0.9, 0.45)), 0.1, 0.05)]
float opTongue(float a, float b, float height, float halfWidth) {
    return min(a, max(a - height, abs(b) - halfWidth));
}

// The shape grown by `radius`; its edges become round. As exact as before outside.
// lipschitz[1.0]
// example[opRound(sdBox(p, vec3(0.4, 0.3, 0.4)), 0.2)]
float opRound(float distance, float radius) {
    return distance - radius;
}

// Only the skin of the shape, `halfThickness` to both sides. Again and again it makes an onion.
// lipschitz[1.0]
// example[opIntersection(opShell(opShell(sdSphere(p, 0.6), 0.12), 0.05), p.z - 0.1)]
float opShell(float distance, float halfThickness) {
    return abs(distance) - halfThickness;
}

// A 2-D shape extended by `halfHeight` to both sides of its plane; `height` is the coordinate across
// it. As exact as the 2-D shape.
// lipschitz[1.0]
// example[opExtrude(sd2Star(p.xy, 5.0, 0.9, 0.45), p.z, 0.2)]
float opExtrude(float distance2, float height, float halfHeight) {
    vec2 q = vec2(distance2, abs(height) - halfHeight);
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
}

// As opExtrude with edges of `radius`; the shape keeps its size where that is exact inside.
// lipschitz[1.0]
// example[opExtrudeRounded(sd2Star(p.xy, 5.0, 0.9, 0.45), p.z, 0.2, 0.08)]
float opExtrudeRounded(float distance2, float height, float halfHeight, float radius) {
    return opExtrude(distance2 + radius, height, halfHeight - radius) - radius;
}

// The surface moved outwards by `height`, a function of the point with a slope of at most `slope`.
// lipschitz[1.0]
// example[opDisplace(sdSphere(p, 0.7), 0.1 * sin(6.0 * p.x) * sin(6.0 * p.y), 0.6)]
float opDisplace(float distance, float height, float slope) {
    return (distance - height) / (1.0 + slope);
}

// Between two shapes: the first for amount = 0, the second for 1.
// bound
// lipschitz[1.0]
// example[opMorph(sdBox(p, vec3(0.5)), sdSphere(p, 0.75), 0.5)]
float opMorph(float a, float b, float amount) {
    return mix(a, b, amount);
}
