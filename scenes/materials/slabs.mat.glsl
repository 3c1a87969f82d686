// Concrete slabs with joints, without flicker in the distance: joints are averaged over the width of
// the pixel, stains fade where they are finer than it. Repeats after one slab.
uniform vec3 concrete;  // color[0.150, 0.147, 0.142] Slab
uniform vec3 joint;     // color[0.030, 0.030, 0.030] Joint
uniform float size;     // slider[0.5, 3.0, 10.0] Edge of a slab, m
uniform float gap;      // slider[0.005, 0.035, 0.2] Width of a joint, m

// How much of [x - width / 2, x + width / 2] lies in joints, which are around whole numbers.
float jointsUpTo(float x, float halfGap) {
    return floor(x) * 2.0 * halfGap + min(fract(x), halfGap) + max(fract(x) - 1.0 + halfGap, 0.0);
}

float jointShare(float x, float width, float halfGap) {
    float a = jointsUpTo(x - 0.5 * width, halfGap);
    return (jointsUpTo(x + 0.5 * width, halfGap) - a) / width;
}

// Value noise with a whole number of cells a slab.
float hash(vec2 cell, float cells) {
    vec2 c = cell - cells * floor(cell / cells);
    return fract(sin(dot(c, vec2(12.9898, 78.233))) * 43758.5453);
}

float stains(vec2 p, float cells) {
    vec2 cell = floor(p * cells), t = fract(p * cells);
    t = t * t * (3.0 - 2.0 * t);
    float low = mix(hash(cell, cells), hash(cell + vec2(1.0, 0.0), cells), t.x);
    float high = mix(hash(cell + vec2(0.0, 1.0), cells), hash(cell + vec2(1.0, 1.0), cells), t.x);
    return mix(low, high, t.y) - 0.5;
}

void material(inout Surface s) {
    vec2 p = s.localPosition.xz / size;
    float width = max(s.footprint / size, 0.0005);
    float halfGap = 0.5 * gap / size;
    float inJoint = max(jointShare(p.x, width, halfGap), jointShare(p.y, width, halfGap));
    vec3 seen = clamp(vec3(1.0) - vec3(4.0, 11.0, 37.0) * width, 0.0, 1.0);
    float stain = 0.5 * seen.x * stains(p, 4.0) + 0.3 * seen.y * stains(p, 11.0) +
                  0.2 * seen.z * stains(p, 37.0);
    s.baseColor = mix(concrete * (1.0 + 0.6 * stain), joint, inJoint);
    s.roughness = clamp(s.roughness + 0.25 * stain + 0.3 * inJoint, 0.05, 1.0);
}
