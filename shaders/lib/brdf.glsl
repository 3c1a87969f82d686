// SPDX-License-Identifier: MIT
// Lobes of reflection. GGX: Walter et al. 2007 (distribution), Heitz 2014 (Smith, height-correlated),
// Schlick 1994 (Fresnel). Sheen: Estevez & Kulla, Production Friendly Microfacet Sheen BRDF, 2017
// (distribution), Neubelt & Pettineo 2013 (visibility).
// Vectors are unit, in world space or in a frame where the normal is +z, as named.

// Fresnel's reflectance is f0 + (f90 - f0) times this.
float schlickPower(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return m2 * m2 * m;
}

// The sine from the cross product: from the cosine, narrow lobes would be rounded away.
float ggxDistribution(vec3 n, vec3 h, float alpha) {
    float a2 = alpha * alpha;
    vec3 sine = cross(n, h);
    float d = square(dot(n, h)) * a2 + dot(sine, sine);
    return a2 / (kPi * d * d);
}

// Value of the sheen lobe, without its colour.
float sheenLobe(vec3 n, vec3 toViewer, vec3 toLight, vec3 h, float alpha) {
    float nDotL = max(dot(n, toLight), 0.0);
    float nDotV = max(dot(n, toViewer), 1.0e-3);
    vec3 sine = cross(n, h);
    float inverse = 1.0 / alpha;
    float distribution = (2.0 + inverse) * pow(dot(sine, sine), 0.5 * inverse) / (2.0 * kPi);
    return distribution / (4.0 * (nDotL + nDotV - nDotL * nDotV));
}

// Blinn's highlight, scaled so that a surface seen straight on sends back all of the light, and no
// less straight views more of it: the integral of cos^m(t / 2) cos(t) over the hemisphere, t the angle
// between light and normal, is 8 pi (m + 2^(-m/2)) / ((m + 2) (m + 4)). (Giesen, The Blinn-Phong
// Normalization Zoo, 2009; Akenine-Moller et al., Real-Time Rendering, 3rd ed., has (m + 8) / (8 pi),
// which is near.)
float blinnPhongLobe(float nDotH, float shininess) {
    float scale = (shininess + 2.0) * (shininess + 4.0) /
                  (8.0 * kPi * (shininess + exp2(-0.5 * shininess)));
    return scale * pow(max(nDotH, 1.0e-4), shininess);
}

// G2 / (4 nDotL nDotV)
float smithVisibility(float nDotL, float nDotV, float alpha) {
    float a2 = alpha * alpha;
    float l = nDotV * sqrt(nDotL * nDotL * (1.0 - a2) + a2);
    float v = nDotL * sqrt(nDotV * nDotV * (1.0 - a2) + a2);
    return 0.5 / max(l + v, 1.0e-6);
}

float smithG1(float nDotX, float alpha) {
    float a2 = alpha * alpha;
    return 2.0 * nDotX / (nDotX + sqrt(a2 + (1.0 - a2) * nDotX * nDotX));
}

// A microfacet normal visible from v (Heitz, Sampling the GGX Distribution of Visible Normals,
// JCGT 2018). Frame: normal +z; u in [0, 1) squared.
vec3 sampleVisibleNormal(vec3 v, float alpha, vec2 u) {
    vec3 stretched = normalize(vec3(alpha * v.xy, v.z));
    float lengthSquared = dot(stretched.xy, stretched.xy);
    vec3 t1 = lengthSquared > 0.0 ? vec3(-stretched.y, stretched.x, 0.0) * inversesqrt(lengthSquared)
                                  : vec3(1.0, 0.0, 0.0);
    vec3 t2 = cross(stretched, t1);
    float r = sqrt(u.x);
    float phi = 2.0 * kPi * u.y;
    float p1 = r * cos(phi);
    float p2 = r * sin(phi);
    float s = 0.5 * (1.0 + stretched.z);
    p2 = (1.0 - s) * sqrt(max(0.0, 1.0 - p1 * p1)) + s * p2;
    vec3 n = p1 * t1 + p2 * t2 + sqrt(max(0.0, 1.0 - p1 * p1 - p2 * p2)) * stretched;
    return normalize(vec3(alpha * n.xy, max(1.0e-6, n.z)));
}

// A direction about +z with density cos / pi.
vec3 sampleCosine(vec2 u) {
    float r = sqrt(u.x);
    float phi = 2.0 * kPi * u.y;
    return vec3(r * cos(phi), r * sin(phi), sqrt(max(0.0, 1.0 - u.x)));
}
