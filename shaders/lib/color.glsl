// SPDX-License-Identifier: MIT
// Linear radiance to what a display shows. IEC 61966-2-1 for sRGB.

vec3 srgbFromLinear(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, vec3(lessThanEqual(c, vec3(0.0031308))));
}

// Heat: black, blue, magenta, orange, white; monotone in lightness so that it survives greyscale.
vec3 heat(float x) {
    x = clamp(x, 0.0, 1.0);
    return clamp(vec3(1.9 * x - 0.25, 2.4 * x - 1.3, x < 0.45 ? 1.9 * x : 1.71 - 1.9 * x + square(max(0.0, x - 0.7) * 5.2)), 0.0, 1.0);
}

// A colour for a number, far from those of its neighbours (golden-ratio hue).
vec3 colorOfId(uint id) {
    float hue = fract(float(id & 0xffffu) * 0.618034 + 0.12);
    float value = 0.75 + 0.25 * fract(float(id & 0xffffu) * 0.41421);
    vec3 rgb = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return value * mix(vec3(1.0), rgb, 0.72);
}

// OKLCH, a space where equal lightness looks equally light (Ottosson, "A perceptual color space for
// image processing", 2020): lightness 0 to 1, chroma 0 to about 0.3, hue in radians.
vec3 linearFromOklch(float lightness, float chroma, float hue) {
    vec2 ab = chroma * vec2(cos(hue), sin(hue));
    vec3 cone = lightness + vec3(dot(ab, vec2(0.3963377774, 0.2158037573)),
                                 dot(ab, vec2(-0.1055613458, -0.0638541728)),
                                 dot(ab, vec2(-0.0894841775, -1.2914855480)));
    cone = cone * cone * cone;
    return vec3(dot(cone, vec3(4.0767416621, -3.3077115913, 0.2309699292)),
                dot(cone, vec3(-1.2684380046, 2.6097574011, -0.3413193965)),
                dot(cone, vec3(-0.0041960863, -0.7034186147, 1.7076147010)));
}
