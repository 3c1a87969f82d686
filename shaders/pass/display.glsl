// SPDX-License-Identifier: MIT
// Scene light to display light: exposure, tone map, sRGB, extra gamma, and a dither of one step so
// that smooth skies do not band in 8 bits. Views of data other than light pass unchanged.
#include "scene/frame.glsl"
#include "lib/color.glsl"
#include "lib/tone.glsl"
#include "lib/random.glsl"

uniform sampler2D mean;

bool isLight(int view) {
    return view == VITRINE_VIEW_COLOR || view == VITRINE_VIEW_DIRECT || view == VITRINE_VIEW_REFLECTION;
}

vec3 toneMap(int curve, vec3 c) {
    bool agx = curve == VITRINE_TONE_AGX;
    // The dear one in a loop, because the lanes of a CPU skip nothing else.
    while (agx && mayLoop()) {
        agx = false;
        c = toneMapAgx(c);
    }
    if (curve == VITRINE_TONE_FILMIC) return toneMapFilmic(c);
    if (curve == VITRINE_TONE_ACES) return toneMapAces(c);
    if (curve == VITRINE_TONE_REINHARD) return toneMapReinhard(c);
    return c;
}

vec4 displayPass(ivec2 pixel) {
    int size = int(frame.jitter.z);
    vec3 c = vec3(0.0);
    for (int i = 0; i < size * size; i++)
        c += texelFetch(mean, pixel * size + ivec2(i % size, i / size), 0).rgb;
    c /= float(size * size);
    int view = frame.image.w;
    if (view == VITRINE_VIEW_ALBEDO) return vec4(srgbFromLinear(c), 1.0);
    if (!isLight(view)) return vec4(c, 1.0);
    c = max(c, 0.0) * frame.display.x;
    c = toneMap(frame.image.z, c);
    c = pow(srgbFromLinear(c), vec3(1.0 / frame.display.y));
    // Triangular noise of one step of 8 bits, the same in every run.
    uvec4 bits = pcg4d(uvec4(uint(pixel.x), uint(pixel.y), 77u, 0u));
    vec2 u = unitFloats(bits.xy);
    return vec4(c + (u.x - u.y) * (1.0 / 255.0) * step(c, vec3(254.0 / 255.0)), 1.0);
}
