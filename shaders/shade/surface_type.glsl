// SPDX-License-Identifier: MIT
// What material snippets see of the point that is shaded, and what they may change.
struct Surface {
    vec3 localPosition;  // object space
    vec3 position;       // world space, m
    vec3 normal;         // world space, unit, towards the viewer; may be changed
    vec2 uv;             // meshes; zero on fields
    int part;            // of the mesh or the field
    float footprint;     // width of a pixel here, m: patterns finer than this should fade
    vec3 geometricNormal;  // of what is really there, world space, unit, towards the viewer
    bool inside;           // it is seen from its back
    vec3 localNormal;      // as `normal` at first, but outwards and in object space, unit
    vec3 localFootprint;   // the pixel's widths along the axes of the object, in its units
    float curvature;       // mean, 1/m: 1/r on a ball of radius r, below 0 in hollows
    float curvatureRadius; // of fields: what it is taken over, m

    vec3 baseColor;
    float metallic;
    float roughness;
    vec3 emission;
    float occlusion;  // of ambient light, by a texture; 1: none
    float ior;
    float specular;
    vec3 specularColor;
    float transmission;
    vec3 absorption;  // inside, 1/m
    bool thin;        // light that passes is not refracted
    float clearcoat;
    float clearcoatRoughness;
    vec3 clearcoatNormal;
    vec3 sheenColor;
    float sheenRoughness;
    vec3 subsurface;         // of light from behind, what comes through nothing thick; times baseColor
    float subsurfaceRadius;  // of the substance, what leaves 1/e of it, m
    vec3 highlightColor;  // model blinn-phong: of light from one direction, what the highlight has
    float shininess;      // and its exponent

    // Found from the above by prepareReflection(); what a snippet writes here is lost.
    vec3 f0;            // reflectance at normal incidence, with light that bounces on microfacets
    vec3 f90;           // and at grazing incidence
    vec3 diffuse;       // albedo of the body
    vec3 through;       // albedo of what passes, before Fresnel's part
    float bodyShare;    // of light that the layers above leave to body and mirror
    float sheenScale;
    float coatAlbedo;
    float sheenAlbedo;
    vec3 specularAlbedo;
};
