// SPDX-License-Identifier: MIT
// What material snippets see of the point that is shaded, and what they may change.
struct Surface {
    vec3 localPosition;  // object space
    vec3 position;       // world space, m
    vec3 normal;         // world space, unit, towards the viewer; may be changed
    vec2 uv;             // meshes; zero on fields
    int part;            // of the mesh or the field
    float footprint;     // width of a pixel here, m: patterns finer than this should fade
    vec3 baseColor;
    float metallic;
    float roughness;
    vec3 emission;
    float occlusion;     // of ambient light, by a texture; 1: none
};
