// SPDX-License-Identifier: MIT
// Many copies for the price of one. Space is cut into cells, each with a copy about its middle.
//
// A point knows only the copy in its own cell, but the nearest surface may stand in the next one:
// then the distance is too long and a ray passes through. Which form is right:
// - the shape is its own mirror image in the middle planes of the cell: plain repetition is exact;
// - it is not, but copies may be mirrored: the ...Mirrored forms are exact for whatever stays inside
//   of its cell, because a mirror image is never nearer than the thing itself;
// - neither: ask all neighbours (a loop over the ...Neighbour form, exact), or take the smaller of
//   the distance and domCellWall plus a little (cheap: one evaluation, more steps).

// One coordinate repeated for ever with a period of `spacing`; 0 is the middle of a cell.
// Source: the distance to the nearest multiple.
// lipschitz[1.0]
// example[sdSphere(vec3(domRepeatLine(p.x, 0.5), p.yz), 0.2)]
float domRepeatLine(float x, float spacing) {
    return x - spacing * round(x / spacing);
}

// Repetition for ever along all three axes.
// lipschitz[1.0]
// example[sdBox(domRepeat(p, vec3(0.7)), vec3(0.2, 0.15, 0.25))]
vec3 domRepeat(vec3 p, vec3 spacing) {
    return p - spacing * round(p / spacing);
}

// Which cell a point lies in, as whole numbers: to vary the copies by.
// example[min(sdSphere(domRepeat(p, vec3(0.7)), 0.1 + 0.2 * noiseHash(domRepeatCell(p, vec3(0.7))).x), domCellWall(p, vec3(0.7)) + 0.01)]
vec3 domRepeatCell(vec3 p, vec3 spacing) {
    return round(p / spacing);
}

// Repetition in the cells `low` to `high` (whole numbers, both included) along each axis.
// Source: the nearest cell is found for each axis alone, so it may be clamped for each axis alone.
// lipschitz[1.0]
// example[sdBox(domRepeatLimited(p, vec3(0.6), vec3(-1.0, 0.0, -1.0), vec3(1.0, 1.0, 0.0)), vec3(0.2, 0.15, 0.25))]
vec3 domRepeatLimited(vec3 p, vec3 spacing, vec3 low, vec3 high) {
    return p - spacing * clamp(round(p / spacing), low, high);
}

// Repetition for ever in which every other copy is a mirror image, along each axis. Exact for what
// stays inside of its cell.
// Source: folding a strip of paper.
// lipschitz[1.0]
// example[sdCapsule(domRepeatMirrored(p, vec3(0.8)), vec3(-0.2, -0.3, 0.0), vec3(0.25, 0.1, 0.2), 0.08)]
vec3 domRepeatMirrored(vec3 p, vec3 spacing) {
    vec3 q = p - 0.5 * spacing;
    return 0.5 * spacing - abs(q - 2.0 * spacing * round(q / (2.0 * spacing)));
}

// Copies around the y axis; the first stands on the +x side. `count` is a whole number.
// lipschitz[1.0]
// example[sdSphere(domRepeatPolar(p, 7.0) - vec3(0.7, 0.0, 0.0), 0.25)]
vec3 domRepeatPolar(vec3 p, float count) {
    float sector = 6.28318530718 / count;
    float turn = sector * round(atan(p.z, p.x) / sector);
    float c = cos(turn);
    float s = sin(turn);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}

// The same, with each copy mirrored in its own middle plane, so that neighbours meet without a seam.
// lipschitz[1.0]
// example[sdCapsule(domRepeatPolarMirrored(p, 7.0), vec3(0.5, -0.3, 0.0), vec3(0.75, 0.3, 0.25), 0.08)]
vec3 domRepeatPolarMirrored(vec3 p, float count) {
    float sector = 6.28318530718 / count;
    float turn = sector * round(atan(p.z, p.x) / sector);
    float c = cos(turn);
    float s = sin(turn);
    return vec3(c * p.x + s * p.z, p.y, abs(c * p.z - s * p.x));
}

// Neighbour `i` of 8: the cells that meet at the corner nearest to the point. The smallest distance
// of all 8 is exact for shapes that stay within their cell:
//   float d = 1.0e9;
//   for (int i = 0; i < 8; i++) d = min(d, shape(domRepeatNeighbour(p, spacing, i)));
// Source: axis by axis. A point in the right half of its cell and a place b of the cell are at most
// half a cell apart, or b lies to the left; either way the copies of b in the own cell and in the
// one to the right are nearer than that in the one to the left.
// lipschitz[1.0]
// example[min(min(min(sdSphere(domRepeatNeighbour(p, vec3(0.8), 0) - 0.1, 0.2), sdSphere(domRepeatNeighbour(p, vec3(0.8), 1) - 0.1, 0.2)), min(sdSphere(domRepeatNeighbour(p, vec3(0.8), 2) - 0.1, 0.2), sdSphere(domRepeatNeighbour(p, vec3(0.8), 3) - 0.1, 0.2))), min(min(sdSphere(domRepeatNeighbour(p, vec3(0.8), 4) - 0.1, 0.2), sdSphere(domRepeatNeighbour(p, vec3(0.8), 5) - 0.1, 0.2)), min(sdSphere(domRepeatNeighbour(p, vec3(0.8), 6) - 0.1, 0.2), sdSphere(domRepeatNeighbour(p, vec3(0.8), 7) - 0.1, 0.2))))]
vec3 domRepeatNeighbour(vec3 p, vec3 spacing, int i) {
    vec3 cell = round(p / spacing);
    vec3 q = p - spacing * cell;
    vec3 side = vec3(q.x < 0.0 ? -1.0 : 1.0, q.y < 0.0 ? -1.0 : 1.0, q.z < 0.0 ? -1.0 : 1.0);
    vec3 move = vec3(float(i & 1), float((i >> 1) & 1), float((i >> 2) & 1));
    return q - spacing * side * move;
}

// Neighbour `i` of 2 around the y axis: the copy of the point's own sector and the next nearest.
// lipschitz[1.0]
// example[min(sdSphere(domRepeatPolarNeighbour(p, 5.0, 0) - vec3(0.6, 0.0, 0.25), 0.2), sdSphere(domRepeatPolarNeighbour(p, 5.0, 1) - vec3(0.6, 0.0, 0.25), 0.2))]
vec3 domRepeatPolarNeighbour(vec3 p, float count, int i) {
    float sector = 6.28318530718 / count;
    float angle = atan(p.z, p.x);
    float turn = sector * round(angle / sector);
    turn += float(i) * (angle < turn ? -sector : sector);
    float c = cos(turn);
    float s = sin(turn);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}

// Distance from the point to the nearest wall of its cell. The smaller of this, plus a hundredth of
// a cell, and the distance to the cell's own copy leads a ray safely into the next cell.
// lipschitz[1.0]
// example[min(sdSphere(domRepeat(p, vec3(0.8)) - vec3(0.15, 0.1, 0.0), 0.2), domCellWall(p, vec3(0.8)) + 0.01)]
float domCellWall(vec3 p, vec3 spacing) {
    vec3 q = 0.5 * spacing - abs(p - spacing * round(p / spacing));
    return min(q.x, min(q.y, q.z));
}
