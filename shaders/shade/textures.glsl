// SPDX-License-Identifier: MIT
// The textures of a material, applied to a surface. One loop with one place that samples.
#include "shade/surface_type.glsl"
#include "scene/fetch.glsl"

// What the geometry gives for texturing.
struct TextureFrame {
    vec2 uv;
    vec2 uv2;         // the second set
    vec3 tangent;     // world space: where u grows, not unit
    vec3 bitangent;   // where v grows
    vec2 footprint;   // width of the pixel in the texture coordinates of both sets
    vec4 color;       // of the vertices
};

#if HAS_TEXTURES
#include "scene/texture.glsl"

// 0 to 3: the channel itself, 4 to 7: one minus it.
float channelOf(vec4 c, int channel) {
    int i = channel & 3;
    float value = i == 0 ? c.r : i == 1 ? c.g : i == 2 ? c.b : c.a;
    return channel < 4 ? value : 1.0 - value;
}

vec3 bentNormal(vec3 normal, TextureFrame geometry, vec3 texel, float scale) {
    vec3 n = vec3((2.0 * texel.xy - 1.0) * scale, 2.0 * texel.z - 1.0);
    // The tangents in the plane of the interpolated normal: without this, flat triangles show.
    vec3 t = geometry.tangent - dot(geometry.tangent, normal) * normal;
    vec3 b = geometry.bitangent - dot(geometry.bitangent, normal) * normal;
    float lengths = dot(t, t) * dot(b, b);
    if (lengths <= 0.0) return normal;
    return normalize(n.x * normalize(t) + n.y * normalize(b) + n.z * normal);
}

void applyTextures(int firstSlot, int slots, TextureFrame geometry, inout Surface s) {
    vec3 bent = s.normal;
    for (int i = 0; i < slots; i++) {
        int at = firstSlot + i * VITRINE_TEXTURE_SLOT_TEXELS;
        vec4 a = fetchTable(at);
        vec4 m = fetchTable(at + 1);
        vec4 b = fetchTable(at + 2);
        int purpose = int(a.x);
        bool second = a.z > 0.5;  // set of coordinates
        vec2 uv = mat2(m.xy, m.zw) * (second ? geometry.uv2 : geometry.uv) + b.xy;
        float scale = sqrt(abs(m.x * m.w - m.y * m.z));
        float footprint = (second ? geometry.footprint.y : geometry.footprint.x) * scale;
        bool color = purpose == VITRINE_SLOT_BASE_COLOR || purpose == VITRINE_SLOT_EMISSION ||
                     purpose == VITRINE_SLOT_SPECULAR_COLOR || purpose == VITRINE_SLOT_SHEEN_COLOR;
        vec4 c = sampleTexture(int(a.y), uv, footprint, color);
        if (purpose == VITRINE_SLOT_BASE_COLOR) s.baseColor *= c.rgb;
        if (purpose == VITRINE_SLOT_METALLIC_ROUGHNESS) {
            s.roughness *= channelOf(c, int(b.z));
            s.metallic *= channelOf(c, int(b.w));
        }
        if (purpose == VITRINE_SLOT_NORMAL) bent = bentNormal(s.normal, geometry, c.rgb, a.w);
        if (purpose == VITRINE_SLOT_OCCLUSION) s.occlusion = 1.0 + a.w * (c.r - 1.0);
        if (purpose == VITRINE_SLOT_EMISSION) s.emission *= c.rgb;
        if (purpose == VITRINE_SLOT_SPECULAR) s.specular *= c.a;
        if (purpose == VITRINE_SLOT_SPECULAR_COLOR) s.specularColor *= c.rgb;
#if HAS_TRANSMISSION
        if (purpose == VITRINE_SLOT_TRANSMISSION) s.transmission *= c.r;
#endif
#if HAS_LAYERS
        if (purpose == VITRINE_SLOT_CLEARCOAT) s.clearcoat *= c.r;
        if (purpose == VITRINE_SLOT_CLEARCOAT_ROUGHNESS) s.clearcoatRoughness *= c.g;
        if (purpose == VITRINE_SLOT_CLEARCOAT_NORMAL)
            s.clearcoatNormal = bentNormal(s.normal, geometry, c.rgb, a.w);
        if (purpose == VITRINE_SLOT_SHEEN_COLOR) s.sheenColor *= c.rgb;
        if (purpose == VITRINE_SLOT_SHEEN_ROUGHNESS) s.sheenRoughness *= c.a;
#endif
    }
    s.normal = bent;
}
#endif
