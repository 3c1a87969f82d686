// SPDX-License-Identifier: MIT
// Textures out of the pages that pack/texture_atlas.hpp lays out.
#include "scene/fetch.glsl"

uniform sampler2DArray colorPages;  // sRGB
uniform sampler2DArray dataPages;

// One component of a texture coordinate into [0, 1]. 0: repeat, 1: clamp, 2: mirror.
float wrapCoordinate(float x, int mode) {
    if (mode == 0) return fract(x);
    if (mode == 1) return clamp(x, 0.0, 1.0);
    return 1.0 - abs(1.0 - 2.0 * fract(0.5 * x));
}

struct TextureEntry {
    vec2 size;       // of level 0, texels
    int firstLevel;  // texel of the table of levels
    int levels;
    ivec2 wrap;
    bool nearest;
};

TextureEntry fetchTexture(int texture) {
    vec4 a = fetchTable(texture);
    int wrap = int(a.w);
    int sides = int(a.x);
    return TextureEntry(vec2(1 << (sides & 31), 1 << (sides >> 5)), int(a.y), int(a.z),
                        ivec2(wrap & 3, (wrap >> 2) & 3), (wrap & 16) != 0);
}

// Bilinear in one level, or in the middle of a texel; uv inside [0, 1], v downwards.
vec3 levelCoordinates(TextureEntry entry, int level, vec2 uv, float pageSize) {
    vec4 place = fetchTable(entry.firstLevel + level);
    vec2 size = max(floor(entry.size / float(1 << level)), vec2(1.0));
    vec2 at = uv * size;
    if (entry.nearest) at = min(floor(at), size - 1.0) + 0.5;
    return vec3((place.yz + at) / pageSize, place.x);
}

// How much of a surface a texel may cover where the cone of a pixel has this radius. A pixel seen at
// a slant covers an ellipse. Its mean width keeps textures sharp, and samples share the work of not
// flickering (the scale of ray differentials in pbrt, Pharr et al. 2023).
float textureFootprint(float radius, float cosine) {
    return 2.0 * radius * inversesqrt(cosine) *
           max(0.25, inversesqrt(float(max(1, frame.sampling.y))));
}

// `footprint`: width of the pixel in the texture, as a part of it, along its longer side.
vec4 sampleTexture(int texture, vec2 uv, float footprint, bool color) {
    TextureEntry entry = fetchTexture(texture);
    uv = vec2(wrapCoordinate(uv.x, entry.wrap.x), wrapCoordinate(1.0 - uv.y, entry.wrap.y));
    float texels = footprint * max(entry.size.x, entry.size.y);
    float level = clamp(log2(max(texels, 1.0e-6)), 0.0, float(entry.levels - 1));
    int fine = int(level);
    int coarse = min(fine + 1, entry.levels - 1);
    float blend = level - float(fine);
    if (color) {
        float size = float(textureSize(colorPages, 0).x);
        return mix(textureLod(colorPages, levelCoordinates(entry, fine, uv, size), 0.0),
                   textureLod(colorPages, levelCoordinates(entry, coarse, uv, size), 0.0), blend);
    }
    float size = float(textureSize(dataPages, 0).x);
    return mix(textureLod(dataPages, levelCoordinates(entry, fine, uv, size), 0.0),
               textureLod(dataPages, levelCoordinates(entry, coarse, uv, size), 0.0), blend);
}
