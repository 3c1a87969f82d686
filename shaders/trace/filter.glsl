// SPDX-License-Identifier: MIT
// What lets rays pass: holes (alpha masks), veils (blend), glass, and backs that are not seen. Reads
// the materials' numbers, the picture of the base colour and the colours of vertices; material
// snippets are not asked.
#include "scene/fetch.glsl"
#include "lib/hit_record.glsl"
#include "lib/random.glsl"
#include "lib/brdf.glsl"
#if HAS_TEXTURES
#include "scene/texture.glsl"
#endif

#if HAS_FILTERS
// Set by passes whose rays look for the closest surface: veils stop them by chance.
ivec2 filterPixel = ivec2(0);
const int kDimensionFilter = 256;  // and all above

struct Barrier {
    int flags;
    float opacity;  // after the cutoff
    vec3 glass;     // share of light that passes its substance
    vec3 absorption;
    bool back;      // the ray comes from behind
};

// `footprints`: of the first and the second texture coordinates.
vec4 barrierColor(int material, vec2 uv, vec2 uv2, vec2 footprints) {
    vec4 color = vec4(fetchTable(material).rgb, fetchTable(material + 3).z);
#if HAS_TEXTURES
    vec4 slots = fetchTable(material + 3);
    for (int i = 0; i < int(slots.y); i++) {
        if (!mayLoop()) break;
        int at = int(slots.x) + i * VITRINE_TEXTURE_SLOT_TEXELS;
        vec4 a = fetchTable(at);
        vec4 m = fetchTable(at + 1);
        vec4 b = fetchTable(at + 2);
        bool second = a.z > 0.5;  // set of coordinates
        float footprint =
            (second ? footprints.y : footprints.x) * sqrt(abs(m.x * m.w - m.y * m.z));
        vec2 place = mat2(m.xy, m.zw) * (second ? uv2 : uv) + b.xy;
        if (int(a.x) == VITRINE_SLOT_BASE_COLOR)
            color *= sampleTexture(int(a.y), place, footprint, true);
    }
#endif
    return color;
}

Barrier loadBarrier(uvec4 record, Ray ray) {
    Instance instance = fetchInstance(int(record.x));
    float t = recordDistance(record);
    int part = int(fieldPart(record));
    vec3 normal = unpackNormal(record.z);
    vec2 uv = vec2(0.0);
    vec2 second = vec2(0.0);
    vec2 footprints = vec2(0.0);
    vec4 vertexColor = vec4(1.0);
    if (instance.kind == VITRINE_KIND_MESH) {
        uvec4 triangle = fetchTriangle(instance.parameters + int(record.y));
        Vertex a = fetchVertex(int(triangle.x));
        Vertex b = fetchVertex(int(triangle.y));
        Vertex c = fetchVertex(int(triangle.z));
        vec2 vw = unpackBarycentrics(record.z);
        uv = (1.0 - vw.x - vw.y) * a.uv + vw.x * b.uv + vw.y * c.uv;
        part = int(triangle.w);
        vec3 edge1 = transformVector(instance.worldFromObject, b.position - a.position);
        vec3 edge2 = transformVector(instance.worldFromObject, c.position - a.position);
        normal = transformNormal(instance.objectFromWorld,
                                 cross(b.position - a.position, c.position - a.position));
        normal = normalize(normal);
        vec2 uv1 = b.uv - a.uv;
        vec2 uv2 = c.uv - a.uv;
        vec2 uvAreas = vec2(uv1.x * uv2.y - uv1.y * uv2.x, 0.0);
#if HAS_VERTEX_EXTRAS
        VertexExtras extraA = fetchVertexExtras(instance, int(triangle.x));
        VertexExtras extraB = fetchVertexExtras(instance, int(triangle.y));
        VertexExtras extraC = fetchVertexExtras(instance, int(triangle.z));
        second = (1.0 - vw.x - vw.y) * extraA.uv2 + vw.x * extraB.uv2 + vw.y * extraC.uv2;
        vertexColor =
            (1.0 - vw.x - vw.y) * extraA.color + vw.x * extraB.color + vw.y * extraC.color;
        uv1 = extraB.uv2 - extraA.uv2;
        uv2 = extraC.uv2 - extraA.uv2;
        uvAreas.y = uv1.x * uv2.y - uv1.y * uv2.x;
#endif
        float area = length(cross(edge1, edge2));
        vec2 perMetre = area > 0.0 ? sqrt(abs(uvAreas) / area) : vec2(0.0);
#if HAS_TEXTURES
        footprints = textureFootprint(ray.radius + frame.cameraEye.w * t,
                                      max(0.1, abs(dot(ray.direction, normal)))) *
                     perMetre;
#endif
    }
    vec4 list = fetchTable(instance.materials);
    part = clamp(part, 0, int(list.y) - 1);
    int material = frame.tables.y +
                   int(fetchTable(instance.materials + part).x) * VITRINE_MATERIAL_TEXELS;
    vec4 color = vertexColor * barrierColor(material, uv, second, footprints);
    vec4 c = fetchTable(material + 2);
    vec4 e = fetchTable(material + 4);
    vec4 f = fetchTable(material + 5);

    Barrier barrier;
    barrier.flags = int(c.z);
    float cutoff = fetchTable(material + 3).w;
    barrier.opacity = 1.0;
    if ((barrier.flags & VITRINE_ALPHA_MASK) != 0) barrier.opacity = color.a < cutoff ? 0.0 : 1.0;
    if ((barrier.flags & VITRINE_ALPHA_BLEND) != 0) barrier.opacity = color.a;
    float cosine = dot(ray.direction, normal);
    barrier.back = cosine > 0.0;
    float index = (e.w - 1.0) / (e.w + 1.0);
    vec3 f0 = min(index * index * e.rgb, 1.0) * c.w;
    vec3 fresnel = f0 + (c.w - f0) * schlickPower(abs(cosine));
    barrier.glass = f.w * (1.0 - fetchTable(material).w) * color.rgb * (1.0 - fresnel);
    barrier.absorption = (barrier.flags & VITRINE_MATERIAL_THIN) != 0 ? vec3(0.0) : f.rgb;
    return barrier;
}

// Is a ray that looks for surfaces stopped? The same ray in the same sample always is, or never.
bool stopsRay(Barrier barrier, uvec4 record) {
    bool culled = (barrier.flags & VITRINE_MATERIAL_SINGLE_SIDED) != 0;
    if (culled && barrier.back && barrier.glass == vec3(0.0)) return false;
    int dimension = kDimensionFilter + int((record.x * 7919u + record.y * 104729u) & 0xffffu) +
                    frame.sampling.z * 65536;
    float chance = random2(filterPixel, frame.sampling.x, frame.sampling.y, dimension, frame.sampling.w).x;
    return chance < barrier.opacity;
}
#endif
