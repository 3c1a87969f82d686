// SPDX-License-Identifier: MIT
// How a surface answers light: glTF 2.0 metallic-roughness (appendix B) with KHR_materials_specular,
// _ior, _sheen, _clearcoat, _transmission and _volume.
//
// Layers, from the top: varnish (GGX), sheen (Charlie), mirror (GGX), body (Lambert or glass). Each
// leaves to those below what it does not send back to the viewer ("albedo scaling", Estevez & Kulla
// 2017), with albedos from a table: nothing is lost and nothing is made. Light that bounces between
// the microfacets of the mirror is added as a factor (Turquin, Practical Multiple Scattering
// Compensation for Microfacet Models, 2019).
//
// With HAS_CLASSIC there are surfaces that have a body and, instead of all else, the highlight of
// Blinn, Models of Light Reflection for Computer Synthesized Pictures, SIGGRAPH 1977.
//
// Defines: HAS_LAYERS (varnish, sheen), HAS_TRANSMISSION, HAS_CLASSIC.
#include "shade/surface_type.glsl"
#include "shade/albedo_table.glsl"
#include "lib/math.glsl"
#include "lib/brdf.glsl"

// A light without size makes no highlight on a perfect mirror, yet everybody expects one: the
// lobe of lights is never narrower than that of a sun a few degrees wide.
const float kLeastLightAlpha = 0.02;
// Below this the lobe is narrower than any pixel, and the mirror direction alone is taken.
const float kMirrorAlpha = 0.0005;
const float kCoatF0 = 0.04;
// Smoother cloth would be a line of light at the outline.
const float kLeastSheenRoughness = 0.3;

float alphaOf(Surface s) { return s.roughness * s.roughness; }

bool isReference() { return frame.path.x == VITRINE_MODE_REFERENCE; }

// What a reflection here does to highlights seen in it: a mirror nothing; a lobe spreads them, and
// curved surfaces spread the lobe, for which the square root is a plain allowance.
float highlightBlur(float alpha) { return alpha > kMirrorAlpha ? sqrt(alpha) : 0.0; }

// Fills the members of the surface that do not depend on where light comes from.
void prepareReflection(inout Surface s, vec3 toViewer) {
    float index = (s.ior - 1.0) / (s.ior + 1.0);
    vec3 dielectric = min(index * index * s.specularColor, 1.0) * s.specular;
    vec3 lobe = directionalAlbedo(dot(s.normal, toViewer), s.roughness);
    float single = lobe.x + lobe.y;
    float lost = (1.0 - single) / single;
    vec3 dielectricBoost = 1.0 + dielectric * lost;
    vec3 metalBoost = 1.0 + s.baseColor * lost;
    s.f0 = mix(dielectric * dielectricBoost, s.baseColor * metalBoost, s.metallic);
    s.f90 = mix(s.specular * dielectricBoost, metalBoost, s.metallic);
    s.bodyShare = 1.0;
    s.sheenScale = 0.0;
    s.sheenAlbedo = 0.0;
    s.coatAlbedo = 0.0;
#if HAS_LAYERS
    vec3 coat = directionalAlbedo(dot(s.clearcoatNormal, toViewer), s.clearcoatRoughness);
    s.coatAlbedo = s.clearcoat * (kCoatF0 * coat.x + coat.y);
    float sheen = directionalAlbedo(dot(s.normal, toViewer),
                                    max(s.sheenRoughness, kLeastSheenRoughness)).z;
    // The lobe gives more than it gets where smooth cloth is seen edge on.
    s.sheenScale = (1.0 - s.coatAlbedo) / max(sheen, 1.0);
    s.sheenAlbedo = sheen * s.sheenScale;
    s.bodyShare = 1.0 - s.coatAlbedo - s.sheenAlbedo * maxComponent(s.sheenColor);
#endif
    s.specularAlbedo = s.bodyShare * (s.f0 * lobe.x + s.f90 * lobe.y);
    float mirrored = maxComponent(dielectricBoost * (dielectric * lobe.x + s.specular * lobe.y));
    vec3 body = s.bodyShare * (1.0 - s.metallic) * s.baseColor;
    s.diffuse = (1.0 - s.transmission) * (1.0 - mirrored) * body;
    s.through = s.transmission * body;
#if HAS_CLASSIC
    s.diffuse *= 1.0 - maxComponent(s.highlightColor);
#endif
}

// `cosine`: between the ray and the normal of the microfacet. From the inside, the angle that counts
// is that outside of the surface, if there is one.
vec3 fresnelOf(Surface s, float cosine) {
    float c = cosine;
#if HAS_TRANSMISSION
    if (s.inside && !s.thin && s.transmission > 0.0) {
        float squared = 1.0 - s.ior * s.ior * (1.0 - c * c);
        if (squared <= 0.0) return vec3(1.0);
        c = sqrt(squared);
    }
#endif
    return s.f0 + (s.f90 - s.f0) * schlickPower(c);
}

// ---- where the bounce pass looks next ----

// The chances with which it takes the mirror (or glass), the varnish and the body (or sheen).
struct Chances {
    float mirror, coat, body;
};

bool splitsHere() { return frame.path.z != VITRINE_SPLIT_NONE && frame.sampling.z == 0; }

Chances chancesOf(Surface s) {
    Chances c = Chances(maxComponent(s.specularAlbedo), s.coatAlbedo, 0.0);
    if (isReference())
        c.body = maxComponent(s.diffuse) + maxComponent(s.sheenColor) * s.sheenAlbedo;
#if HAS_TRANSMISSION
    if (splitsHere() && frame.path.z == VITRINE_SPLIT_TRANSMIT)
        return Chances(s.transmission > 0.0 ? 1.0 : 0.0, 0.0, 0.0);
    if (!splitsHere()) c.mirror += maxComponent(s.through);
#endif
    float sum = c.mirror + c.coat + c.body;
    if (sum <= 0.0) return Chances(0.0, 0.0, 0.0);
    return Chances(c.mirror / sum, c.coat / sum, c.body / sum);
}

// Of a microfacet that reflects this much: the chance that a ray is reflected rather than refracted.
// In hybrid mode a way that is worth less than the threshold is not taken: it would be noise.
float reflectChance(Surface s, vec3 fresnel) {
#if HAS_TRANSMISSION
    if (s.transmission > 0.0) {
        if (splitsHere()) return frame.path.z == VITRINE_SPLIT_REFLECT ? 1.0 : 0.0;
        float reflected = maxComponent(fresnel);
        float refracted = maxComponent(max(1.0 - fresnel, 0.0) * s.through);
        float chance = reflected / max(reflected + refracted, 1.0e-6);
        if (isReference()) return chance;
        float least = frame.shading.y;
        return chance < least ? 0.0 : chance > 1.0 - least ? 1.0 : chance;
    }
#endif
    return 1.0;
}

// ---- light from a direction ----

struct Answer {
    vec3 value;  // radiance to the viewer for unit radiance from there, a steradian: BSDF times cosine
    float pdf;   // density, a steradian, with which the bounce pass looks there; 0: never, or exactly
};

// A GGX lobe: x: value times cosine, without Fresnel; y: density of sampling it.
vec2 ggxLobe(vec3 n, vec3 toViewer, vec3 toLight, vec3 h, float alpha, float sampledAlpha) {
    float nDotL = dot(n, toLight);
    if (nDotL <= 0.0) return vec2(0.0);
    float nDotV = max(dot(n, toViewer), 1.0e-3);
    float value = 0.0;
    float pdf = 0.0;
    if (alpha > kMirrorAlpha)
        value = ggxDistribution(n, h, alpha) * smithVisibility(nDotL, nDotV, alpha) * nDotL;
    if (sampledAlpha > kMirrorAlpha)
        pdf = ggxDistribution(n, h, sampledAlpha) * smithG1(nDotV, sampledAlpha) / (4.0 * nDotV);
    return vec2(value, pdf);
}

// For a direction that is checked against the true surface already.
Answer evaluateLobes(Surface s, vec3 toViewer, vec3 toLight, float leastAlpha, bool diffuseToo) {
    vec3 h = normalize(toViewer + toLight);
    float vDotH = dot(toLight, h);
    float nDotL = max(dot(s.normal, toLight), 0.0);
    Chances chances = chancesOf(s);
    float alpha = alphaOf(s);
    vec3 fresnel = fresnelOf(s, vDotH);
    vec2 mirror = ggxLobe(s.normal, toViewer, toLight, h, max(alpha, leastAlpha), alpha);
    vec3 value = s.bodyShare * mirror.x * fresnel;
    float pdf = chances.mirror * reflectChance(s, fresnel) * mirror.y;
    if (diffuseToo) value += s.diffuse * (nDotL / kPi);
    pdf += chances.body * nDotL / kPi;
#if HAS_LAYERS
    float coatAlpha = square(s.clearcoatRoughness);
    vec2 coat = ggxLobe(s.clearcoatNormal, toViewer, toLight, h, max(coatAlpha, leastAlpha), coatAlpha);
    value += coat.x * s.clearcoat * (kCoatF0 + (1.0 - kCoatF0) * schlickPower(vDotH));
    pdf += chances.coat * coat.y;
    if (diffuseToo && nDotL > 0.0)
        value += s.sheenScale * s.sheenColor *
                 (nDotL * sheenLobe(s.normal, toViewer, toLight, h,
                                    square(max(s.sheenRoughness, kLeastSheenRoughness))));
#endif
#if HAS_CLASSIC
    if (diffuseToo) value += s.highlightColor * (nDotL * blinnPhongLobe(dot(s.normal, h), s.shininess));
#endif
    return Answer(value, pdf);
}

// Light that is reflected, by all lobes or (diffuseToo false) by those that mirror. No lobe is taken
// as narrower than `leastAlpha`: kLeastLightAlpha for lights without size, and more where the path
// has come by a blurred reflection, in which a sharp highlight is noise and a soft one is what it
// averages to.
Answer evaluateReflection(Surface s, vec3 toViewer, vec3 toLight, float leastAlpha, bool diffuseToo) {
    // Behind the surface that is really there, whatever its bent normal says.
    if (dot(s.geometricNormal, toLight) <= 0.0) return Answer(vec3(0.0), 0.0);
    Answer answer = evaluateLobes(s, toViewer, toLight, leastAlpha, diffuseToo);
    if (frame.sampling.z >= frame.path.y) answer.pdf = 0.0;  // no bounce follows
    return answer;
}

// Of light that comes from everywhere alike: what the bounce pass does not follow in hybrid mode.
vec3 ambientAlbedo(Surface s) { return s.diffuse + s.sheenAlbedo * s.sheenColor; }
