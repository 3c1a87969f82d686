// SPDX-License-Identifier: MIT
// Radiance that comes from outside the scene: a gradient, or a picture that is split in two. What is
// brighter than a limit is a light that is sampled; what is below is ambient light.
#include "scene/sky.glsl"

const int kSkyAmbient = 0;
const int kSkyBright = 1;

#if HAS_SKY
vec3 skyRadiance(vec3 direction, float level, int part) {
    vec4 texel = skyTexel(direction, level);
    vec3 bright = texel.rgb * (texel.a / max(dot(texel.rgb, vec3(0.2126, 0.7152, 0.0722)), 1.0e-20));
    // In reference mode all of it is a light.
    vec3 ambient = texel.rgb * (1.0 - frame.sky.w);
    return part == kSkyAmbient ? ambient : bright + texel.rgb - ambient;
}
#else
vec3 gradientRadiance(vec3 direction) {
    float up = direction.y;
    vec3 above = mix(frame.background[1].rgb, frame.background[0].rgb, smoothstep(0.0, 1.0, up));
    return mix(above, frame.background[2].rgb, smoothstep(0.0, 0.04, -up));
}

// Its mean over the directions that a surface sees, by their cosine. The share of the zenith is by
// three bands of harmonics (Ramamoorthi & Hanrahan, An Efficient Representation for Irradiance
// Environment Maps, SIGGRAPH 2001), within 0.006.
vec3 gradientMean(vec3 normal) {
    float up = normal.y;
    float zenith = max(0.0, 0.203 + (0.35 + 0.1406 * up) * up);
    float above = 0.5 + 0.5 * up;
    return zenith * frame.background[0].rgb + max(0.0, above - zenith) * frame.background[1].rgb +
           (1.0 - above) * frame.background[2].rgb;
}
#endif
