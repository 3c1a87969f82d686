// SPDX-License-Identifier: MIT
// The light tunnel in which car makers look at bodies: bars of light along the y axis of the
// object, around it. Their mirror images show what a surface's normals do. Without flicker: the bars
// are averaged over the width of the pixel.
uniform vec3 bar;     // color[1.0, 0.97, 0.92] Light of a bar
uniform vec3 gap;     // color[0.010, 0.012, 0.018] Light between them
uniform float bars;   // slider[4, 40, 120] How many around the axis
uniform float share;  // slider[0.05, 0.4, 0.95] How much of the tunnel is bars

// How much of [0, x] lies in bars, which begin at whole numbers.
float barsUpTo(float x) { return floor(x) * share + min(fract(x), share); }

void material(inout Surface s) {
    float around = length(s.localPosition.xz);
    float x = bars * (atan(s.localPosition.x, s.localPosition.z) / 6.2831853 + 1.0);
    float width = clamp(bars * s.footprint / (6.2831853 * max(around, 0.001)), 0.001, 4.0);
    float inBar = (barsUpTo(x + 0.5 * width) - barsUpTo(x - 0.5 * width)) / width;
    s.emission = mix(gap, bar, inBar);
}
