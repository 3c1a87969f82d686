// SPDX-License-Identifier: MIT
// From a hit record to a surface. Nothing behind this point asks who found the hit.
#include "scene/fetch.glsl"
#include "lib/hit_record.glsl"
#include "lib/color.glsl"
#include "shade/reflection.glsl"
#include "shade/textures.glsl"
#include "generated/material.glsl"

struct Hit {
    Surface surface;
    vec3 geometricNormal;  // world space, unit, towards the viewer
    vec3 rayOrigin;        // where rays towards lights start, lifted off the surface
    vec3 behind;           // where rays start that pass through it
    vec3 way;              // share of light that is not absorbed between here and the viewer
    int material;
    float radius;          // of the pixel's cone here, m
};

// A smooth-shaded mesh is shadowed by its flat triangles in steps. Starting shadow rays from the
// curved surface that the normals suggest hides them (Hanika, Hacking the Shadow Terminator, Ray
// Tracing Gems II, 2021). Returns the shift from p, in the space of the arguments.
vec3 terminatorShift(vec3 p, Vertex a, Vertex b, Vertex c, vec3 weights, float side) {
    vec3 toA = p - a.position;
    vec3 toB = p - b.position;
    vec3 toC = p - c.position;
    toA = -min(0.0, side * dot(toA, a.normal)) * side * a.normal;
    toB = -min(0.0, side * dot(toB, b.normal)) * side * b.normal;
    toC = -min(0.0, side * dot(toC, c.normal)) * side * c.normal;
    return weights.x * toA + weights.y * toB + weights.z * toC;
}

// Nothing but a matt body.
void makePlain(inout Surface s) {
    s.metallic = 0.0;
    s.specular = 0.0;
    s.transmission = 0.0;
    s.clearcoat = 0.0;
    s.sheenColor = vec3(0.0);
    s.subsurface = vec3(0.0);
}

// Shows its base colour and answers no light.
void makeUnlit(inout Surface s) {
    makePlain(s);
    s.highlightColor = vec3(0.0);
    s.emission = s.baseColor;
    s.baseColor = vec3(0.0);
}

// The number in the mesh or field of what was hit.
uint numberOf(uvec4 record) {
    return fetchInstance(int(record.x)).kind == VITRINE_KIND_MESH ? record.y : fieldPart(record);
}

// Mean curvature of the surface that the normals of a triangle's corners suggest, 1/m: half the
// divergence of the normal, with the vectors that are dual to the edges. All in the world.
float triangleCurvature(vec3 edge1, vec3 edge2, vec3 turn1, vec3 turn2) {
    vec3 n = cross(edge1, edge2);
    float squared = dot(n, n);
    if (squared <= 0.0) return 0.0;
    return 0.5 * (dot(turn1, cross(edge2, n)) + dot(turn2, cross(n, edge1))) / squared;
}

// How wide a cone of width 1 is along each axis of the object, in its units. Its cross-section, thrown onto
// the surface along the ray, is an ellipse; a row of the matrix tells how fast a coordinate
// changes on it: by the part of the row in the plane, and along the ellipse's long axis more.
float widthAlong(vec3 row, vec3 direction, vec3 n) {
    float cosine = -dot(direction, n);
    float off = dot(row, n);
    float lengthwise = (dot(row, direction) + cosine * off) / max(cosine, 1.0e-3);
    return sqrt(max(dot(row, row) - off * off, 0.0) + square(lengthwise));
}

vec3 widthsOf(vec4 rows[3], vec3 direction, vec3 n) {
    return vec3(widthAlong(rows[0].xyz, direction, n), widthAlong(rows[1].xyz, direction, n),
                widthAlong(rows[2].xyz, direction, n));
}

void clampSurface(inout Surface s) {
    s.baseColor = clamp(s.baseColor, 0.0, 1.0);
    s.metallic = clamp(s.metallic, 0.0, 1.0);
    s.roughness = clamp(s.roughness, 0.0, 1.0);
    s.normal = normalize(s.normal);
    s.specular = clamp(s.specular, 0.0, 1.0);
    s.specularColor = max(s.specularColor, 0.0);
    s.ior = max(s.ior, 1.0);
#if HAS_TRANSMISSION
    s.transmission = clamp(s.transmission, 0.0, 1.0) * (1.0 - s.metallic);
    s.absorption = max(s.absorption, 0.0);
#endif
#if HAS_SUBSURFACE
    s.subsurface = clamp(s.subsurface, 0.0, 1.0);
    s.subsurfaceRadius = max(s.subsurfaceRadius, 1.0e-6);
#endif
#if HAS_LAYERS
    s.clearcoat = clamp(s.clearcoat, 0.0, 1.0);
    s.clearcoatRoughness = clamp(s.clearcoatRoughness, 0.0, 1.0);
    s.clearcoatNormal = normalize(s.clearcoatNormal);
    s.sheenColor = clamp(s.sheenColor, 0.0, 1.0);
    s.sheenRoughness = clamp(s.sheenRoughness, 0.0, 1.0);
#endif
#if HAS_CLASSIC
    s.highlightColor = clamp(s.highlightColor, 0.0, 1.0);
    s.shininess = clamp(s.shininess, 1.0, 1.0e5);
#endif
}

void loadMaterial(inout Hit hit, Instance instance, TextureFrame geometry) {
    vec4 list = fetchTable(instance.materials);
    int part = clamp(hit.surface.part, 0, int(list.y) - 1);
    hit.material = int(fetchTable(instance.materials + part).x);
    int i = frame.tables.y + hit.material * VITRINE_MATERIAL_TEXELS;
    vec4 a = fetchTable(i);
    vec4 b = fetchTable(i + 1);
    vec4 c = fetchTable(i + 2);
    hit.surface.baseColor = a.rgb * geometry.color.rgb;
    hit.surface.metallic = a.w;
    hit.surface.emission = b.rgb;
    hit.surface.roughness = b.w;
    hit.surface.occlusion = 1.0;
    hit.surface.specular = c.w;
    vec4 e = fetchTable(i + 4);
    hit.surface.specularColor = e.rgb;
    hit.surface.ior = e.w;
    hit.surface.transmission = 0.0;
    hit.surface.absorption = vec3(0.0);
    hit.surface.thin = (int(c.z) & VITRINE_MATERIAL_THIN) != 0;
    hit.surface.clearcoat = 0.0;
    hit.surface.clearcoatRoughness = 0.0;
    hit.surface.clearcoatNormal = hit.surface.normal;
    hit.surface.sheenColor = vec3(0.0);
    hit.surface.sheenRoughness = 0.0;
    hit.surface.subsurface = vec3(0.0);
    hit.surface.subsurfaceRadius = 0.0;
#if HAS_SUBSURFACE
    vec4 scattering = fetchTable(i + 8);
    hit.surface.subsurface = scattering.rgb;
    hit.surface.subsurfaceRadius = scattering.w;
#endif
#if HAS_TRANSMISSION
    vec4 f = fetchTable(i + 5);
    hit.surface.absorption = f.rgb;
    hit.surface.transmission = f.w;
#endif
#if HAS_LAYERS
    vec4 g = fetchTable(i + 6);
    hit.surface.clearcoat = g.x;
    hit.surface.clearcoatRoughness = g.y;
    vec4 h = fetchTable(i + 7);
    hit.surface.sheenColor = h.rgb;
    hit.surface.sheenRoughness = h.w;
#endif
    hit.surface.highlightColor = vec3(0.0);
    hit.surface.shininess = 1.0;
    hit.surface.curvatureRadius = 0.0;
#if HAS_CLASSIC
    vec4 k = fetchTable(i + 9);
    hit.surface.highlightColor = k.rgb;
    hit.surface.shininess = k.w;
#endif
#if HAS_CURVATURE
    hit.surface.curvatureRadius = fetchTable(instance.materials + part).z;
#endif
#if HAS_TEXTURES
    vec4 d = fetchTable(i + 3);
    applyTextures(int(d.x), int(d.y), geometry, hit.surface);
#endif
    evaluateMaterial(int(c.x), hit.surface, int(c.y));
#if HAS_CLASSIC
    if ((int(c.z) & VITRINE_MATERIAL_CLASSIC) != 0)
        makePlain(hit.surface);  // lambert or blinn-phong; their highlight is their own
    else
        hit.surface.highlightColor = vec3(0.0);
#endif
    if ((int(c.z) & VITRINE_MATERIAL_UNLIT) != 0) makeUnlit(hit.surface);
    clampSurface(hit.surface);
}

// The record must be of a surface.
Hit loadHit(uvec4 record, Ray ray) {
    Instance instance = fetchInstance(int(record.x));
    float t = recordDistance(record);
    vec3 position = ray.origin + t * ray.direction;
    vec3 local = transformPoint(instance.objectFromWorld, position);

    Hit hit;
    hit.radius = ray.radius + frame.cameraEye.w * t;
    hit.surface.position = position;
    hit.surface.localPosition = local;
    hit.surface.curvature = 0.0;
    float lift = 1.0e-5 * (maxComponent(abs(position)) + t);
    vec3 shift = vec3(0.0);
    TextureFrame geometry =
        TextureFrame(vec2(0.0), vec2(0.0), vec3(0.0), vec3(0.0), vec2(0.0), vec4(1.0));
    vec2 uvPerMetre = vec2(0.0);
    if (instance.kind == VITRINE_KIND_MESH) {
        uvec4 triangle = fetchTriangle(instance.parameters + int(record.y));
        Vertex a = fetchVertex(int(triangle.x));
        Vertex b = fetchVertex(int(triangle.y));
        Vertex c = fetchVertex(int(triangle.z));
        vec2 vw = unpackBarycentrics(record.z);
        vec3 weights = vec3(1.0 - vw.x - vw.y, vw.x, vw.y);
        vec3 flatNormal = cross(b.position - a.position, c.position - a.position);
        vec3 smoothNormal = weights.x * a.normal + weights.y * b.normal + weights.z * c.normal;
        vec3 worldFlat = normalize(transformNormal(instance.objectFromWorld, flatNormal));
        vec3 worldSmooth = normalize(transformNormal(instance.objectFromWorld, smoothNormal));
        float side = dot(worldFlat, ray.direction) > 0.0 ? -1.0 : 1.0;
        hit.geometricNormal = side * worldFlat;
        hit.surface.inside = side < 0.0;
        hit.surface.localNormal = normalize(smoothNormal);
#if HAS_CURVATURE
        hit.surface.curvature = triangleCurvature(
            transformVector(instance.worldFromObject, b.position - a.position),
            transformVector(instance.worldFromObject, c.position - a.position),
            normalize(transformNormal(instance.objectFromWorld, b.normal)) -
                normalize(transformNormal(instance.objectFromWorld, a.normal)),
            normalize(transformNormal(instance.objectFromWorld, c.normal)) -
                normalize(transformNormal(instance.objectFromWorld, a.normal)));
#endif
        // A mesh wound against its normals still shades on the side that is seen.
        float facing = dot(worldSmooth, hit.geometricNormal) < 0.0 ? -1.0 : 1.0;
        hit.surface.normal = facing * worldSmooth;
        hit.surface.uv = weights.x * a.uv + weights.y * b.uv + weights.z * c.uv;
        hit.surface.part = int(triangle.w);
#if HAS_VERTEX_EXTRAS
        VertexExtras extraA = fetchVertexExtras(instance, int(triangle.x));
        VertexExtras extraB = fetchVertexExtras(instance, int(triangle.y));
        VertexExtras extraC = fetchVertexExtras(instance, int(triangle.z));
        geometry.color =
            weights.x * extraA.color + weights.y * extraB.color + weights.z * extraC.color;
#endif
#if HAS_TEXTURES
        vec3 edge1 = transformVector(instance.worldFromObject, b.position - a.position);
        vec3 edge2 = transformVector(instance.worldFromObject, c.position - a.position);
        vec2 uv1 = b.uv - a.uv;
        vec2 uv2 = c.uv - a.uv;
        float uvArea = uv1.x * uv2.y - uv1.y * uv2.x;
        float mirrored = uvArea < 0.0 ? -1.0 : 1.0;
        geometry.uv = hit.surface.uv;
        geometry.tangent = mirrored * (uv2.y * edge1 - uv1.y * edge2);
        geometry.bitangent = mirrored * (uv1.x * edge2 - uv2.x * edge1);
        // Texture coordinates per metre: the roots of the ratio of the areas (ray cones, Akenine-
        // Moller et al. 2021, "Improved Shader and Texture Level of Detail Using Ray Cones").
        float worldArea = length(cross(edge1, edge2));
        vec2 uvAreas = vec2(uvArea, 0.0);
#if HAS_VERTEX_EXTRAS
        geometry.uv2 = weights.x * extraA.uv2 + weights.y * extraB.uv2 + weights.z * extraC.uv2;
        uv1 = extraB.uv2 - extraA.uv2;
        uv2 = extraC.uv2 - extraA.uv2;
        uvAreas.y = uv1.x * uv2.y - uv1.y * uv2.x;
#endif
        uvPerMetre = worldArea > 0.0 ? sqrt(abs(uvAreas) / worldArea) : vec2(0.0);
#if HAS_TANGENTS
        vec4 tangent = weights.x * fetchTangent(instance, int(triangle.x)) +
                       weights.y * fetchTangent(instance, int(triangle.y)) +
                       weights.z * fetchTangent(instance, int(triangle.z));
        if (dot(tangent.xyz, tangent.xyz) > 0.0) {
            // The bitangent by the object's own orientation: right in mirrored instances, too.
            vec3 bitangent = cross(smoothNormal, tangent.xyz) * (tangent.w < 0.0 ? -1.0 : 1.0);
            geometry.tangent = transformVector(instance.worldFromObject, tangent.xyz);
            geometry.bitangent = transformVector(instance.worldFromObject, bitangent);
        }
#endif
        // Seen from behind, a bump is a dent: all of the bent normal turns round.
        geometry.tangent *= facing;
        geometry.bitangent *= facing;
#endif
        float normalSide = dot(smoothNormal, flatNormal) < 0.0 ? -side : side;
        shift = terminatorShift(local, a, b, c, weights, normalSide);
        shift = transformVector(instance.worldFromObject, shift);
    } else {
        vec3 n = unpackNormal(record.z);
        hit.surface.inside = dot(n, ray.direction) > 0.0;
        hit.geometricNormal = hit.surface.inside ? -n : n;
        hit.surface.normal = hit.geometricNormal;
        hit.surface.uv = vec2(0.0);
        hit.surface.part = int(fieldPart(record));
        hit.surface.localNormal = normalize(transformNormal(instance.worldFromObject, n));
#if HAS_CURVATURE
        hit.surface.curvature = fieldCurvature(record);
#endif
        // More than the tolerance with which the next ray will look for the same surface.
        float scale = length(transformVector(instance.worldFromObject, vec3(0.57735027)));
        lift += 0.35 * hit.radius + 2.0 * instance.finest * scale;
    }
    float cosine = max(0.1, -dot(ray.direction, hit.geometricNormal));
    hit.surface.footprint = 2.0 * hit.radius / cosine;
    hit.surface.localFootprint =
        hit.radius * widthsOf(instance.objectFromWorld, ray.direction, hit.geometricNormal);
    hit.rayOrigin = position + shift + lift * hit.geometricNormal;
    // Deeper by the tolerance with which a field was hit in front of itself.
    hit.behind = position - 2.0 * lift * hit.geometricNormal;
    hit.surface.geometricNormal = hit.geometricNormal;
#if HAS_TEXTURES
    geometry.footprint = textureFootprint(hit.radius, cosine) * uvPerMetre;
#endif
    loadMaterial(hit, instance, geometry);
    hit.way = vec3(1.0);
#if HAS_TRANSMISSION
    // Seen from its back, it was the ray that was inside.
    if (hit.surface.inside && !hit.surface.thin && hit.surface.transmission > 0.0)
        hit.way = exp(-t * hit.surface.absorption);
#endif
    prepareReflection(hit.surface, -ray.direction);
    return hit;
}
