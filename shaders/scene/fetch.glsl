// SPDX-License-Identifier: MIT
// The only place that knows how scene data are stored: texture buffers on the desktop, textures
// 2048 texels wide in GLSL ES 3.00, which has no buffers that shaders can index.
#include "scene/frame.glsl"

#if DIALECT_ES
uniform usampler2D sceneSlots;      // the trees: nodes, triangles, instances
uniform usampler2D sceneTriangles;  // three vertices and the part of each triangle
uniform sampler2D sceneVertices;    // position, u | normal, v; then lists of the mesh, see below
uniform sampler2D sceneTables;      // instances, materials, lights, parameters
#if HAS_SKY
uniform sampler2D skyTree;  // nodes of the trees of pack/sky_map.hpp
#endif
#define FETCH(sampler, i) texelFetch(sampler, ivec2((i) & 2047, (i) >> 11), 0)
#else
uniform usamplerBuffer sceneSlots;
uniform usamplerBuffer sceneTriangles;
uniform samplerBuffer sceneVertices;
uniform samplerBuffer sceneTables;
#if HAS_SKY
uniform samplerBuffer skyTree;
#endif
#define FETCH(sampler, i) texelFetch(sampler, i)
#endif

struct Slot {
    uvec4 a, b, c;
};

Slot fetchSlot(int slot) {
    int i = slot * VITRINE_SLOT_TEXELS;
    return Slot(FETCH(sceneSlots, i), FETCH(sceneSlots, i + 1), FETCH(sceneSlots, i + 2));
}

// x, y, z: vertices; w: part
uvec4 fetchTriangle(int triangle) { return FETCH(sceneTriangles, triangle); }

struct Vertex {
    vec3 position;
    vec3 normal;
    vec2 uv;
};

Vertex fetchVertex(int vertex) {
    vec4 a = FETCH(sceneVertices, vertex * VITRINE_VERTEX_TEXELS);
    vec4 b = FETCH(sceneVertices, vertex * VITRINE_VERTEX_TEXELS + 1);
    return Vertex(a.xyz, b.xyz, vec2(a.w, b.w));
}

struct Instance {
    vec4 objectFromWorld[3];  // rows of an affine matrix
    vec4 worldFromObject[3];
    int kind;                 // VITRINE_KIND_*
    int flags;                // VITRINE_INSTANCE_*
    int shape;                // mesh: root slot of its tree; field: number of the field
    int materials;            // index of part 0's material in the material lists
    int extras, tangents;     // mesh: beginnings of its lists in sceneVertices, for vertex 0; 0: none
    int parameters;           // mesh: first triangle; field: first parameter
    vec3 boxMin;              // object space
    vec3 boxMax;
    float stepScale;          // of a field: 1 / its Lipschitz bound
    float finest;             // of a field: smallest distance that means anything, object space
};

vec4 fetchTable(int texel) { return FETCH(sceneTables, texel); }

Instance fetchInstance(int instance) {
    int i = frame.tables.x + instance * VITRINE_INSTANCE_TEXELS;
    Instance result;
    for (int row = 0; row < 3; row++) {
        result.objectFromWorld[row] = fetchTable(i + row);
        result.worldFromObject[row] = fetchTable(i + 3 + row);
    }
    vec4 indices = fetchTable(i + 6);
    vec4 low = fetchTable(i + 7);
    vec4 high = fetchTable(i + 8);
    result.kind = int(indices.x) & 1;
    result.flags = int(indices.x);
    result.shape = int(indices.y);
    result.materials = int(indices.z);
    result.parameters = int(indices.w);
    result.boxMin = low.xyz;
    result.boxMax = high.xyz;
    result.extras = int(low.w);
    result.tangents = int(high.w);
    result.stepScale = low.w;
    result.finest = high.w;
    return result;
}

#if HAS_VERTEX_EXTRAS
struct VertexExtras {
    vec2 uv2;
    vec4 color;
};

VertexExtras fetchVertexExtras(Instance instance, int vertex) {
    if (instance.extras == 0) return VertexExtras(vec2(0.0), vec4(1.0));
    vec4 a = FETCH(sceneVertices, instance.extras + vertex);
    vec2 high = floor(a.zw / 4096.0);
    vec2 low = a.zw - 4096.0 * high;
    return VertexExtras(a.xy, vec4(high.x, low.x, high.y, low.y) / 4095.0);
}
#endif

#if HAS_TANGENTS
// Where u grows, and the sign of the bitangent; zero where there is none.
vec4 fetchTangent(Instance instance, int vertex) {
    return instance.tangents == 0 ? vec4(0.0) : FETCH(sceneVertices, instance.tangents + vertex);
}
#endif

vec3 transformPoint(vec4 rows[3], vec3 p) {
    return vec3(dot(rows[0].xyz, p) + rows[0].w, dot(rows[1].xyz, p) + rows[1].w,
                dot(rows[2].xyz, p) + rows[2].w);
}

vec3 transformVector(vec4 rows[3], vec3 v) {
    return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v));
}

// A normal goes by the inverse transpose: rows of worldFromObject's inverse, transposed.
vec3 transformNormal(vec4 inverseRows[3], vec3 n) {
    return inverseRows[0].xyz * n.x + inverseRows[1].xyz * n.y + inverseRows[2].xyz * n.z;
}

// Parameters of snippets, one texel each. `base` belongs to the instance or the material.
vec4 fetchParameter(int base, int index) { return fetchTable(frame.tables.w + base + index); }
