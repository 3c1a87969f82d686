// SPDX-License-Identifier: MIT
// Patterns that repeat. A pattern takes the width of a pixel in its own units and returns its mean
// over a box of that width, found from an integral that is known: no flicker nearby, and far away the
// even tone that the eye would see.

// A square wave of period 2: 1 between 0 and 1, -1 between 1 and 2.
// Source: its integral is a triangle wave; the mean over a width is a difference of that. Counted
// from the nearest jump, so that far places do not round it away.
// pattern[mix(vec3(0.08, 0.2, 0.45), vec3(0.85), 0.5 + 0.5 * patWave(5.0 * p.x, 5.0 * w.x))]
float patWave(float x, float width) {
    float wide = max(width, 1.0e-3);
    float jump = floor(x + 0.5);
    float q = 0.5 * (x - jump);
    float h = 0.25 * wide;
    float mean = (abs(2.0 * fract(q - h) - 1.0) - abs(2.0 * fract(q + h) - 1.0)) / wide;
    return abs(fract(0.5 * jump) - 0.5) > 0.25 ? mean : -mean;
}

// Stripes across x of period 1: which share of the pixel lies in one. They begin at whole numbers and
// are `share` wide.
// Source: the integral is share * floor(x) + min(fract(x), share).
// pattern[mix(vec3(0.85), vec3(0.45, 0.08, 0.06), patStripes(4.0 * p.x, 0.3, 4.0 * w.x))]
float patStripes(float x, float share, float width) {
    float wide = max(width, 1.0e-3);
    float q = fract(x);
    float low = q - 0.5 * wide;
    float high = q + 0.5 * wide;
    return (share * (floor(high) - floor(low)) + min(fract(high), share) -
            min(fract(low), share)) / wide;
}

// A chess board of squares of edge 1: the share of the pixel that lies on squares like that from
// (0, 0) to (1, 1).
// Source: 1/2 + 1/2 of the product of two square waves; the mean of a product over a box is the
// product of the means, because each factor knows one coordinate only.
// pattern[mix(vec3(0.08, 0.2, 0.45), vec3(0.85), patChecker(4.0 * uvBox(p, n), 4.0 * abs(uvBox(w, n))))]
float patChecker(vec2 p, vec2 width) {
    return 0.5 + 0.5 * patWave(p.x, width.x) * patWave(p.y, width.y);
}

// Tiles of edge 1 with joints around whole numbers, `joint` wide: the share of the pixel in joints.
// pattern[mix(vec3(0.75, 0.72, 0.65), vec3(0.1), patTiles(3.0 * uvBox(p, n), 0.08, 3.0 * abs(uvBox(w, n))))]
float patTiles(vec2 p, float joint, vec2 width) {
    return 1.0 - (1.0 - patStripes(p.x + 0.5 * joint, joint, width.x)) *
                     (1.0 - patStripes(p.y + 0.5 * joint, joint, width.y));
}

// A brick bond: every other course shifted by half a brick. `size` is a brick with its joint. Returns
// (share of the pixel in mortar, column, course, height): column and course are whole numbers, for
// noiseHash; the height is 0 in the mortar and rises to 1 within `joint` of a brick's edge, for
// uvBump or a field.
// Source: patStripes for either kind of joint. A pixel as high as a course sees both of the shifts
// of the upright joints, and from there on their mean counts.
// pattern[mix(vec3(0.42, 0.13, 0.07) + 0.16 * noiseHash(vec3(patBricks(uvBox(p, n), vec2(0.5, 0.2), 0.03, abs(uvBox(w, n))).yz, 0.0)).x, vec3(0.6), patBricks(uvBox(p, n), vec2(0.5, 0.2), 0.03, abs(uvBox(w, n))).x)]
vec4 patBricks(vec2 p, vec2 size, float joint, vec2 width) {
    vec2 q = p / size;
    vec2 wide = width / size;
    vec2 gap = joint / size;
    float course = floor(q.y);
    float x = q.x + (fract(0.5 * course) > 0.25 ? 0.5 : 0.0);
    float bed = patStripes(q.y + 0.5 * gap.y, gap.y, wide.y);
    float here = patStripes(x + 0.5 * gap.x, gap.x, wide.x);
    float beside = patStripes(x + 0.5 + 0.5 * gap.x, gap.x, wide.x);
    float upright = mix(here, 0.5 * (here + beside), clamp(wide.y, 0.0, 1.0));
    vec2 edge = (0.5 - abs(fract(vec2(x, q.y)) - 0.5)) * size - 0.5 * joint;
    float rise = clamp(min(edge.x, edge.y) / joint, 0.0, 1.0);
    return vec4(1.0 - (1.0 - bed) * (1.0 - upright), floor(x), course,
                rise * rise * (3.0 - 2.0 * rise));
}

// Discs of a radius (at most 0.5) in the middles of squares of edge 1: the share of the pixel on one.
// Source: nearby the rim is taken as straight; where the pixel is wider than a square, the mean, pi
// times the radius squared, takes over.
// pattern[mix(vec3(0.85), vec3(0.1, 0.35, 0.3), patDots(4.0 * uvBox(p, n), 0.3, 4.0 * abs(uvBox(w, n))))]
float patDots(vec2 p, float radius, vec2 width) {
    float wide = max(max(width.x, width.y), 1.0e-3);
    float near = clamp((radius - length(fract(p) - 0.5)) / wide + 0.5, 0.0, 1.0);
    return mix(near, 3.14159265359 * radius * radius, smoothstep(0.4, 1.0, wide));
}
