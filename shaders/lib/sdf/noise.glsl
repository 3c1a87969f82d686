// SPDX-License-Identifier: MIT
// Noise to displace surfaces with: noise... has values about 0, no seams and a known slope. A field
// d + h * noise(f * p) has a slope of at most 1 + h * f * slope; opDisplace divides by that.

// Three random numbers from 0 to 1 for a cell with whole coordinates.
// Source: pcg3d of Jarzynski and Olano, Hash Functions for GPU Rendering, JCGT 2020.
// example[min(sdSphere(domRepeat(p, vec3(0.5)), 0.06 + 0.18 * noiseHash(domRepeatCell(p, vec3(0.5))).y), domCellWall(p, vec3(0.5)) + 0.01)]
vec3 noiseHash(vec3 cell) {
    uvec3 v = uvec3(ivec3(cell)) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return vec3(v >> 8u) * (1.0 / 16777216.0);
}

// A random direction of length 1 for a cell.
// Source: equal areas of the sphere project to equal heights on its axis (Archimedes).
// example[min(sdCapsule(domRepeat(p, vec3(0.6)), vec3(0.0), 0.22 * noiseDirection(domRepeatCell(p, vec3(0.6))), 0.05), domCellWall(p, vec3(0.6)) + 0.01)]
vec3 noiseDirection(vec3 cell) {
    vec3 u = noiseHash(cell);
    float z = 2.0 * u.x - 1.0;
    float r = sqrt(max(1.0 - z * z, 0.0));
    float angle = 6.28318530718 * u.y;
    return vec3(r * cos(angle), r * sin(angle), z);
}

// The curve from 0 to 1 whose first and second derivatives vanish at both ends.
// Source: Perlin, Improving Noise, SIGGRAPH 2002: the polynomial of degree 5 with these ends.
// lipschitz[1.875]
// example[(p.y + 0.3 - 0.4 * noiseFade(clamp(p.x + 0.5, 0.0, 1.0))) / 1.25]
float noiseFade(float t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

// Value noise: random values at the corners of cells of edge 1, blended. From -1 to 1.
// Source: the slope. A blend of corner values is their mean for independent choices of the three
// coordinates, with probabilities w = fade(t). By Bessel's inequality the partial derivatives by w,
// each times sqrt(w (1 - w)), have squares that add up to at most 1, so the slope is at most
// fade'(t) / sqrt(w (1 - w)), largest in the middle: 1.875 / 0.5.
// lipschitz[3.75]
// example[opDisplace(sdSphere(p, 0.75), 0.12 * noiseValue(4.0 * p), 0.12 * 4.0 * 3.75)]
// example[noiseValue(7.0 * p) / 7.0]
float noiseValue(vec3 p) {
    vec3 cell = floor(p);
    vec3 q = p - cell;
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        vec3 corner = vec3(float(i & 1), float((i >> 1) & 1), float((i >> 2) & 1));
        vec3 near = 1.0 - abs(q - corner);
        float weight = noiseFade(near.x) * noiseFade(near.y) * noiseFade(near.z);
        sum += weight * (2.0 * noiseHash(cell + corner).x - 1.0);
    }
    return sum;
}

// Gradient noise: random slopes of length 1 at the corners of cells of edge 1, blended. Zero at the
// corners, from about -0.87 to 0.87.
// Source: Perlin, An Image Synthesizer, SIGGRAPH 1985, with the curve of 2002. The slope is the
// largest that any choice of corner directions can give, found by search: for a direction e it is
// the sum over the corners of |w e + d (grad w . e)|, w the weight and d the way from the corner.
// lipschitz[2.8]
// example[opDisplace(sdSphere(p, 0.75), 0.15 * noiseGradient(4.0 * p), 0.15 * 4.0 * 2.8)]
// example[noiseGradient(7.0 * p) / 7.0]
float noiseGradient(vec3 p) {
    vec3 cell = floor(p);
    vec3 q = p - cell;
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        vec3 corner = vec3(float(i & 1), float((i >> 1) & 1), float((i >> 2) & 1));
        vec3 near = 1.0 - abs(q - corner);
        float weight = noiseFade(near.x) * noiseFade(near.y) * noiseFade(near.z);
        sum += weight * dot(noiseDirection(cell + corner), q - corner);
    }
    return sum;
}

// Simplex noise: four corners instead of eight, and no axes to be seen. From about -1 to 1.
// Source: Perlin, Noise Hardware, 2001: space skewed along its diagonal turns cubes, each cut into
// six, into nearly regular tetrahedra. A corner's kernel (1/2 - d^2)^4 ends before the opposite
// face, so there are no seams. The slope: as for noiseGradient.
// lipschitz[5.1]
// example[opDisplace(sdSphere(p, 0.75), 0.08 * noiseSimplex(3.0 * p), 0.08 * 3.0 * 5.1)]
// example[noiseSimplex(7.0 * p) / 7.0]
float noiseSimplex(vec3 p) {
    vec3 cell = floor(p + (p.x + p.y + p.z) / 3.0);
    vec3 q = p - cell + (cell.x + cell.y + cell.z) / 6.0;
    // The way from the first corner to the last goes along the axes, the longest coordinate first.
    vec3 rank = step(q.yzx, q) + step(q.zxy, q);
    float sum = 0.0;
    for (int i = 0; i < 4; i++) {
        vec3 corner = step(2.5 - float(i), rank);
        vec3 d = q - corner + float(i) / 6.0;
        float k = max(0.5 - dot(d, d), 0.0);
        sum += k * k * k * k * dot(noiseDirection(cell + corner), d);
    }
    return 70.0 * sum;
}

// Distance to the nearest of random points, one a cell of edge 1. From 0 to about 1.2.
// Source: Worley, A Cellular Texture Basis Function, SIGGRAPH 1996. The points keep 0.3 away from
// the walls of their cells: then none outside of the 27 nearest cells can be the nearest.
// lipschitz[1.0]
// example[opDisplace(sdSphere(p, 0.75), 0.2 * noiseCellular(4.0 * p), 0.2 * 4.0)]
// example[noiseCellular(7.0 * p) / 7.0]
float noiseCellular(vec3 p) {
    vec3 cell = floor(p);
    float nearest = 9.0;
    for (int i = 0; i < 27; i++) {
        vec3 other = cell + vec3(float(i % 3), float((i / 3) % 3), float(i / 9)) - 1.0;
        vec3 d = other + 0.3 + 0.4 * noiseHash(other) - p;
        nearest = min(nearest, dot(d, d));
    }
    return sqrt(nearest);
}

// Gradient noise in octaves: each twice as fine, `gain` times as high, and turned, so that no axes
// show. From about -1 / (1 - gain) to 1 / (1 - gain).
// Source: Mandelbrot and van Ness 1968 for the idea; the turn is a rotation with whole-number
// proportions, (2, 3, 6) / 7.
// lipschitz[slopeFbm(octaves, gain)]
// example[opDisplace(sdSphere(p, 0.75), 0.12 * noiseFbm(2.5 * p, 4, 0.45), 0.12 * 2.5 * slopeFbm(4, 0.45))]
// example[noiseFbm(3.0 * p, 4, 0.6) / (3.0 * slopeFbm(4, 0.6))]
float noiseFbm(vec3 p, int octaves, float gain) {
    vec3 q = p;
    float sum = 0.0;
    float height = 1.0;
    for (int i = 0; i < octaves; i++) {
        sum += height * noiseGradient(q);
        height *= gain;
        q = 2.0 / 7.0 * vec3(dot(q, vec3(2.0, 3.0, 6.0)), dot(q, vec3(3.0, -6.0, 2.0)),
                             dot(q, vec3(6.0, 2.0, -3.0))) +
            17.3;
    }
    return sum;
}

// Largest slope of noiseFbm: octave i adds (2 gain)^i times that of noiseGradient.
// example[opDisplace(sdSphere(p, 0.75), 0.12 * noiseFbm(2.5 * p, 2, 0.5), 0.12 * 2.5 * slopeFbm(2, 0.5))]
float slopeFbm(int octaves, float gain) {
    float sum = 0.0;
    float slope = 2.8;
    for (int i = 0; i < octaves; i++) {
        sum += slope;
        slope *= 2.0 * gain;
    }
    return sum;
}
