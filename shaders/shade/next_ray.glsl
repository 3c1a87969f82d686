// SPDX-License-Identifier: MIT
// Where a path goes on from a surface: a mirror image, through glass (Walter et al., Microfacet
// Models for Refraction through Rough Surfaces, 2007), or in reference mode anywhere.
#include "shade/reflection.glsl"

struct NextRay {
    vec3 direction;
    vec3 weight;   // zero: the path ends
    float pdf;     // see Answer; 0: the direction was no choice
    float alpha;   // of the lobe
    bool through;  // to the other side of the surface
};

// The direction, moved above the plane of the surface that is really there.
vec3 liftDirection(vec3 direction, vec3 normal) {
    float below = dot(direction, normal);
    return below < 0.0 ? normalize(direction - 1.02 * below * normal) : direction;
}

vec3 inFrameOf(vec3 n, vec3 local) {
    vec3 tangent, bitangent;
    orthonormalBasis(n, tangent, bitangent);
    return local.x * tangent + local.y * bitangent + local.z * n;
}

// A microfacet's normal that the viewer sees.
vec3 sampleFacet(vec3 n, vec3 toViewer, float alpha, vec2 u) {
    if (alpha <= kMirrorAlpha) return n;
    vec3 tangent, bitangent;
    orthonormalBasis(n, tangent, bitangent);
    vec3 v = vec3(dot(toViewer, tangent), dot(toViewer, bitangent), max(dot(n, toViewer), 1.0e-3));
    vec3 m = sampleVisibleNormal(normalize(v), alpha, u);
    return m.x * tangent + m.y * bitangent + m.z * n;
}

#if HAS_TRANSMISSION
// Radiance is not scaled by the squared index as in a medium: it comes back when light leaves it.
NextRay sampleThrough(Surface s, vec3 toViewer, vec3 h, vec3 weight) {
    float alpha = alphaOf(s);
    float eta = s.inside ? s.ior : 1.0 / s.ior;
    vec3 direction;
    if (s.thin) {
        direction = reflect(-toViewer, h);
        direction -= 2.0 * dot(direction, s.normal) * s.normal;
    } else {
        direction = refract(-toViewer, h, eta);
    }
    float nDotL = -dot(s.normal, direction);
    if (nDotL <= 0.0) weight = vec3(0.0);
    if (alpha > kMirrorAlpha) weight *= smithG1(max(nDotL, 0.0), alpha);
    return NextRay(liftDirection(direction, -s.geometricNormal), weight, 0.0, alpha, true);
}
#endif

// `u`: two random numbers for the direction; `choice`: one for the lobe.
NextRay sampleNextRay(Surface s, vec3 toViewer, vec2 u, float choice) {
    Chances chances = chancesOf(s);
    bool mirror = choice < chances.mirror;
    bool coat = !mirror && choice < chances.mirror + chances.coat;
    vec3 n = s.normal;
    float alpha = alphaOf(s);
#if HAS_LAYERS
    n = coat ? s.clearcoatNormal : n;
    alpha = coat ? square(s.clearcoatRoughness) : alpha;
#endif
    vec3 h = sampleFacet(n, toViewer, alpha, u);
    float vDotH = dot(toViewer, h);
    vec3 fresnel = fresnelOf(s, vDotH);
    float reflecting = reflectChance(s, fresnel);
    vec3 exact = s.bodyShare * fresnel / max(chances.mirror * reflecting, 1.0e-6);
    vec3 direction = reflect(-toViewer, h);
#if HAS_TRANSMISSION
    if (mirror && choice >= chances.mirror * reflecting)
        return sampleThrough(s, toViewer, h, max(1.0 - fresnel, 0.0) * s.through /
                                             max(chances.mirror * (1.0 - reflecting), 1.0e-6));
#endif
#if HAS_LAYERS
    if (coat)
        exact = vec3(s.clearcoat * (kCoatF0 + (1.0 - kCoatF0) * schlickPower(vDotH)) / chances.coat);
#endif
    bool body = !mirror && !coat;
    if (body) {
        direction = inFrameOf(s.normal, sampleCosine(u));
        alpha = 1.0;
    }
    if (chances.mirror + chances.coat + chances.body <= 0.0)
        return NextRay(direction, vec3(0.0), 0.0, alpha, false);
    // Where bent normals turn a ray into the surface, it grazes the surface instead.
    vec3 lifted = liftDirection(direction, s.geometricNormal);
    if (alpha <= kMirrorAlpha) return NextRay(lifted, exact, 0.0, alpha, false);
    Answer answer = evaluateLobes(s, toViewer, direction, 0.0, isReference());
    vec3 weight = answer.pdf > 0.0 ? answer.value / answer.pdf : vec3(0.0);
    bool grazes = dot(direction, s.geometricNormal) < 0.0;
    return NextRay(lifted, weight, grazes ? 0.0 : answer.pdf, alpha, false);
}
