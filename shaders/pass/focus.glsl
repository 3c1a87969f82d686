// SPDX-License-Identifier: MIT
// Depth of field by a filter over one sharp sample: each pixel gathers the light of those whose circle
// of confusion covers it, scattered evenly over that circle (scatter as gather: Jimenez, Next
// Generation Post Processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014; polygons of the blades
// as in McIntosh, Riecke & DiPaola, Efficiently Simulating the Bokeh of Polygonal Apertures in a
// Post-Process Depth of Field Shader, CGF 2012).
//
// Three layers are kept apart, seen from the pixel's own depth, and laid over each other: what is in
// front covers by the area that its circles cover; what is as deep covers by its area as well, which
// is less than all near its rim; there, what is behind shows through. Behind an object nothing is
// known, so it is guessed from what can be seen around it. Mirrors and glass are blurred as deep as
// they are, not as deep as what they show: the thin lens is the truth for them.
#include "shade/circles.glsl"

uniform sampler2D levels;
uniform sampler2D extents;
uniform sampler2D reaches;

// How far, in units of the circle, `offset` is from its middle: a length, or what is one for a polygon
// with its corners on the circle, one at the top.
float apertureLength(vec2 offset) {
    float size = length(offset);
    float corners = frame.lens.z;
    if (corners <= 0.0) return size;
    float turn = 2.0 * kPi / corners;
    float angle = atan(offset.y, offset.x) - 0.5 * kPi;
    float fromEdge = (fract(angle / turn) - 0.5) * turn;
    return size * cos(fromEdge) / cos(0.5 * turn);
}

float apertureArea() {
    float corners = frame.lens.z;
    return corners > 0.0 ? 0.5 * corners * sin(2.0 * kPi / corners) : kPi;
}

vec4 focusPass(ivec2 pixel) {
    float own = texelFetch(levels, pixel, 0).w;
    int bands = int(texelFetch(reaches, pixel / kTile, 0).x);
    vec4 front = vec4(0.0);  // light times what it covers; w: what it covers
    vec4 same = vec4(0.0);
    vec4 behind = vec4(0.0);
    float area = apertureArea();
    // One round a band; then one in which what is behind is looked for.
    for (int round = 0; round <= kBands; round++) {
        if (!mayLoop()) break;
        bool looksBehind = round == kBands;
        int level = looksBehind ? 0 : levelOfBand(round);
        float side = float(1 << level);
        int around = int(ceil(radiusOfBand(min(round, kBands - 1)) / side)) + 1;
        float stride = 1.0;
        if (looksBehind) {
            around = abs(own) > 0.5 ? int(min(ceil(abs(own)), 4.0)) + 1 : -1;
            stride = max(1.0, abs(own) / 5.0);
        } else if ((bands & (1 << round)) == 0) {
            around = -1;
        }
        ivec2 corner = levelCorner(level);
        ivec2 size = levelSize(level);
        int width = 2 * around + 1;
        for (int i = 0; i < width * max(width, 0); i++) {
            if (!mayLoop()) break;
            vec2 step = stride * vec2(ivec2(i % width, i / width) - around);
            ivec2 texel = (pixel >> level) + ivec2(floor(step + 0.5));
            if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) continue;
            vec4 light = texelFetch(levels, corner + texel, 0);
            vec4 extent = texelFetch(extents, corner + texel, 0);
            float share = extent.x;
            vec2 offset = vec2(pixel) + 0.5 - (vec2(texel) + 0.5) * side - extent.zw;
            // A texel's own width and the soft rim widen the circle: less, so that its second moment
            // is right.
            float wider = level > 0 ? side * side * (0.4167 + 0.3333 * share) : 0.0;
            float radius = sqrt(max(light.w * light.w - wider, 0.25 * side * side));
            // In front of what is sharp the lens stands on its head.
            float away = apertureLength(light.w < 0.0 ? -offset : offset);
            float covers = clamp((radius - away) / side + 0.5, 0.0, 1.0);
            covers *= side * side / max(area * (radius * radius + side * side / 12.0), side * side);
            if (looksBehind) {
                covers = clamp(abs(own) - away + 0.5, 0.0, 1.0);
                share = 1.0;
            } else if (bandOf(abs(light.w)) != round) {
                share = 0.0;
            }
            float deeper = light.w - own;  // of the circles' radii, which grow with the depth
            float isFront = clamp(-deeper - 1.0, 0.0, 1.0);
            float isBehind = clamp(deeper - 1.0, 0.0, 1.0);
            vec4 arrives = covers * share * vec4(light.rgb, 1.0);
            if (looksBehind) {
                behind += isBehind * arrives;
            } else {
                front += isFront * arrives;
                same += (1.0 - isFront - isBehind) * arrives;
            }
        }
    }
    vec3 sameLight = same.rgb / max(same.w, 1.0e-6);
    vec3 back = behind.w > 0.0 ? behind.rgb / behind.w : sameLight;
    vec3 light = same.w < 1.0 ? same.rgb + (1.0 - same.w) * back : sameLight;
    light = front.w < 1.0 ? front.rgb + (1.0 - front.w) * light : front.rgb / front.w;
    return vec4(light, 1.0);
}
