// SPDX-License-Identifier: MIT
// Patterns as they grow, in space: they need no mapping and have no seams.

// noiseFbm without what is finer than the pixel: octaves fade before their cells are as small as
// `width`.
// Source: Norton, Rockwood and Skolmoski, Clamping, SIGGRAPH 1982: leave out what cannot be shown,
// and its mean, here 0, remains.
// pattern[vec3(0.5 + 0.45 * patNoise(3.0 * p, 5, 0.55, 3.0 * max(w.x, max(w.y, w.z))))]
float patNoise(vec3 p, int octaves, float gain, float width) {
    vec3 q = p;
    float sum = 0.0;
    float height = 1.0;
    float wide = width;
    for (int i = 0; i < octaves; i++) {
        if (wide > 1.0) break;
        sum += height * (1.0 - smoothstep(0.3, 1.0, wide)) * noiseGradient(q);
        height *= gain;
        wide *= 2.0;
        q = 2.0 / 7.0 * vec3(dot(q, vec3(2.0, 3.0, 6.0)), dot(q, vec3(3.0, -6.0, 2.0)),
                             dot(q, vec3(6.0, 2.0, -3.0))) +
            17.3;
    }
    return sum;
}

// Cells around random points, one a cube of edge 1: (distance to the nearest point, to the second
// nearest, two random numbers of the cell). Borders are where the first two are equal.
// Source: Worley, A Cellular Texture Basis Function, SIGGRAPH 1996, with the points of
// noiseCellular.
// pattern[(0.25 + 0.75 * noiseHash(floor(1000.0 * vec3(patCells(3.0 * p).zw, 0.0)))) * smoothstep(0.03, 0.08, patCells(3.0 * p).y - patCells(3.0 * p).x)]
vec4 patCells(vec3 p) {
    vec3 cell = floor(p);
    float first = 9.0;
    float second = 9.0;
    vec2 own = vec2(0.0);
    for (int i = 0; i < 27; i++) {
        vec3 other = cell + vec3(float(i % 3), float((i / 3) % 3), float(i / 9)) - 1.0;
        vec3 u = noiseHash(other);
        vec3 d = other + 0.3 + 0.4 * u - p;
        float squared = dot(d, d);
        second = min(second, max(first, squared));
        if (squared < first) own = u.xy;
        first = min(first, squared);
    }
    return vec4(sqrt(first), sqrt(second), own);
}

// Wood of a trunk along the y axis: from 0, the light wood of spring, to 1, the dark end of a ring.
// There are `rings` a metre, off the circle by about `wobble` metres. Where the pixel is wider than
// a ring it is 0.5, the mean.
// Source: Peachey, Solid Texturing of Complex Surfaces, SIGGRAPH 1985.
// pattern[mix(vec3(0.62, 0.38, 0.18), vec3(0.25, 0.11, 0.04), patWood(p + vec3(0.9, 0.0, 1.6), 7.0, 0.12, max(w.x, w.z)))]
float patWood(vec3 p, float rings, float wobble, float width) {
    float radius = length(p.xz) + wobble * noiseGradient(vec3(1.7, 0.3, 1.7) * p);
    float t = fract(rings * radius);
    float tone = t < 0.8 ? t / 0.8 : 5.0 * (1.0 - t);
    return mix(tone, 0.5, smoothstep(0.4, 1.0, rings * width));
}

// Marble: veins, from 0 between them to 1 in their middles, about one a metre along x, torn by noise.
// Source: Perlin, An Image Synthesizer, SIGGRAPH 1985: a wave whose place is moved by turbulence.
// pattern[mix(vec3(0.86, 0.85, 0.82), vec3(0.16, 0.18, 0.2), patMarble(2.2 * p, 1.2, 2.2 * max(w.x, max(w.y, w.z))))]
float patMarble(vec3 p, float turbulence, float width) {
    float x = p.x + 0.5 * p.y + turbulence * patNoise(p, 5, 0.5, width);
    float wave = abs(2.0 * fract(x) - 1.0);
    float vein = wave * wave * wave * wave;
    return mix(vein, 0.2, smoothstep(0.4, 1.0, width));
}

// Worn edges: from 0 where nothing is worn to 1 on an edge. `curvature` and `radius` are
// Surface.curvature and .curvatureRadius; of a right-angled edge twice their product is 1, and less
// with the distance from it, down to 0 at `radius`. `amount` from 0 to 1 is how far the wear
// reaches; `roughness`, some noise about 0, frays it. With -curvature: dirt in grooves.
// pattern[mix(vec3(0.1, 0.2, 0.25), vec3(0.8, 0.7, 0.5), patWorn(k, r, 0.6, 0.2 * patNoise(14.0 * p, 3, 0.6, 0.1)))]
float patWorn(float curvature, float radius, float amount, float roughness) {
    return smoothstep(-0.12, 0.12, 2.0 * curvature * radius + roughness - (1.0 - amount));
}
