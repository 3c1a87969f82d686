// SPDX-License-Identifier: MIT
// How a surface answers light: the value for a light's direction, and a direction to look next.
#include "shade/surface_type.glsl"
#include "lib/math.glsl"
#include "lib/brdf.glsl"

// A light without size makes no highlight on a perfect mirror, yet everybody expects one: the
// lobe of lights is never narrower than that of a sun a few degrees wide.
const float kLeastLightAlpha = 0.02;
// Below this the lobe is narrower than any pixel, and the mirror direction alone is taken.
const float kMirrorAlpha = 0.0005;

vec3 reflectanceAtNormal(Surface s) { return mix(vec3(0.04), s.baseColor, s.metallic); }

float alphaOf(Surface s) { return s.roughness * s.roughness; }

// What a reflection here does to highlights seen in it: a mirror nothing; a lobe spreads them, and
// curved surfaces spread the lobe, for which the square root is a plain allowance.
float highlightBlur(Surface s) {
    float alpha = alphaOf(s);
    return alpha > kMirrorAlpha ? sqrt(alpha) : 0.0;
}

// Reflected radiance for unit irradiance at normal incidence, times the cosine. `leastAlpha`: see
// Path; a sharp highlight seen by a blurred reflection is noise, a soft one is what it averages to.
vec3 reflectLight(Surface s, vec3 toViewer, vec3 toLight, float leastAlpha) {
    float nDotL = dot(s.normal, toLight);
    float nDotV = max(dot(s.normal, toViewer), 1.0e-3);
    if (nDotL <= 0.0) return vec3(0.0);
    vec3 h = normalize(toViewer + toLight);
    float alpha = max(alphaOf(s), max(leastAlpha, kLeastLightAlpha));
    vec3 fresnel = fresnelSchlick(reflectanceAtNormal(s), dot(toLight, h));
    float lobe = ggxDistribution(clamp(dot(s.normal, h), 0.0, 1.0), alpha) *
                 smithVisibility(nDotL, nDotV, alpha);
    vec3 diffuse = (1.0 - fresnel) * (1.0 - s.metallic) * s.baseColor / kPi;
    return (diffuse + fresnel * lobe) * nDotL;
}

struct NextRay {
    vec3 direction;
    vec3 weight;  // zero: the path ends
};

// Samples the specular lobe; the diffuse one is left to the ambient term.
NextRay sampleReflection(Surface s, vec3 geometricNormal, vec3 toViewer, vec2 u) {
    vec3 n = s.normal;
    vec3 h = n;
    float alpha = alphaOf(s);
    float nDotV = max(dot(n, toViewer), 1.0e-3);
    if (alpha > kMirrorAlpha) {
        vec3 tangent, bitangent;
        orthonormalBasis(n, tangent, bitangent);
        vec3 v = vec3(dot(toViewer, tangent), dot(toViewer, bitangent), nDotV);
        vec3 m = sampleVisibleNormal(normalize(v), alpha, u);
        h = m.x * tangent + m.y * bitangent + m.z * n;
    }
    vec3 direction = reflect(-toViewer, h);
    float nDotL = dot(n, direction);
    // Where interpolated normals turn a mirror ray into the surface, graze the surface instead.
    float below = dot(direction, geometricNormal);
    if (below < 0.0) direction = normalize(direction - 1.02 * below * geometricNormal);
    vec3 weight = fresnelSchlick(reflectanceAtNormal(s), dot(toViewer, h));
    if (alpha > kMirrorAlpha) {
        if (nDotL <= 0.0) return NextRay(direction, vec3(0.0));
        weight *= smithG2(nDotL, nDotV, alpha) / smithG1(nDotV, alpha);
    }
    return NextRay(direction, weight);
}
