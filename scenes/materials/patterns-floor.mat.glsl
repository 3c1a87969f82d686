// SPDX-License-Identifier: MIT
// A chess board of two marbles, filtered: it runs to the horizon and does not flicker there.
uniform float size;  // slider[0.1, 0.5, 2.0] Edge of a square, m

void material(inout Surface s) {
    vec2 place = s.localPosition.xz / size;
    vec2 width = s.localFootprint.xz / size;
    float light = patChecker(place, width);
    // The veins of a slab have nothing to do with those of the next.
    vec3 slab = noiseHash(vec3(floor(place), 0.0));
    float vein = patMarble(1.9 * s.localPosition + 9.0 * slab, 1.3, 1.9 * s.footprint);
    vec3 white = mix(vec3(0.66, 0.64, 0.60), vec3(0.40, 0.39, 0.38), vein);
    vec3 green = mix(vec3(0.030, 0.048, 0.042), vec3(0.16, 0.20, 0.18), vein);
    float joint = patTiles(place, 0.012, width);
    s.baseColor = mix(mix(green, white, light), vec3(0.05), joint);
    s.roughness = mix(0.2, 0.7, joint);
}
