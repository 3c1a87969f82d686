// SPDX-License-Identifier: MIT
// The boxes of a level of the trees, drawn over the picture: first a veil that dims the picture and
// tints each surface with the colour of its box, then the edges of all boxes, those behind a surface
// faint and dashed. Edges are quads on the screen whose borders are smoothed by their distance to the
// line, so that they are as wide near as they are far.
#include "scene/fetch.glsl"
#include "lib/hit_record.glsl"
#include "lib/color.glsl"

uniform usampler2D records;
#if DIALECT_ES
uniform sampler2D boxCorners;
uniform usampler2D boxNumbers;
#else
uniform samplerBuffer boxCorners;   // see frame/tree_boxes.hpp
uniform usamplerBuffer boxNumbers;
#endif

const int kVeil = -1;           // in the place of a box
const int kVerticesOfBox = 72;  // twelve edges of two triangles
const float kNear = 1.0e-3;

struct BoxVertex {
    vec2 position;  // clip space
    vec4 line;      // pixels along the edge and across it, its length, 1 / depth
    ivec2 drawn;    // the box or kVeil; 1: what is in front of the surfaces, 0: what is behind
};

int boxCount() { return frame.sampling.x; }

uint boxNumber(int texel, int i) { return FETCH(boxNumbers, texel + (i >> 2))[i & 3]; }

// A colour a box, in the order of the tree: neighbours in the tree have similar colours, told apart
// by lightness.
vec3 colorOfBox(int box) {
    float hue = FETCH(boxCorners, 2 * box + 1).w;
    float lightness = (box & 1) == 0 ? 0.84 : 0.74;
    return srgbFromLinear(linearFromOklch(lightness, hue < 0.0 ? 0.0 : 0.15, 6.2831853 * hue + 0.5));
}

// x, y: on the image plane at distance 1, in halves of the picture; z: depth, m.
vec3 cameraSpace(vec3 world) {
    vec3 p = world - frame.cameraEye.xyz;
    vec3 right = frame.cameraRight.xyz;
    vec3 up = frame.cameraUp.xyz;
    return vec3(dot(p, right) / dot(right, right), dot(p, up) / dot(up, up),
                dot(p, frame.cameraForward.xyz));
}

float lineWidth() { return clamp(float(frame.image.y) / 480.0, 1.2, 4.0); }

BoxVertex boxVertex(int vertex) {
    if (vertex < 3) {
        vec2 corner = vec2(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0);
        return BoxVertex(corner, vec4(0.0), ivec2(kVeil, 0));
    }
    int edgeVertex = vertex - 3;
    int drawn = edgeVertex / kVerticesOfBox;
    int box = drawn % boxCount();
    int edge = (edgeVertex % kVerticesOfBox) / 6;
    int corner = edgeVertex % 6;

    // The ends: along one axis from low to high, on the others where two bits say.
    vec4 low = FETCH(boxCorners, 2 * box);
    vec4 high = FETCH(boxCorners, 2 * box + 1);
    int axis = edge >> 2;
    bvec2 up = bvec2((edge & 1) != 0, (edge & 2) != 0);
    bvec3 upA = axis == 0 ? bvec3(false, up) : axis == 1 ? bvec3(up.x, false, up.y) : bvec3(up, false);
    bvec3 upB = axis == 0 ? bvec3(true, up) : axis == 1 ? bvec3(up.x, true, up.y) : bvec3(up, true);
    Instance instance = fetchInstance(int(low.w));
    vec3 a = cameraSpace(transformPoint(instance.worldFromObject, mix(low.xyz, high.xyz, vec3(upA))));
    vec3 b = cameraSpace(transformPoint(instance.worldFromObject, mix(low.xyz, high.xyz, vec3(upB))));

    BoxVertex result = BoxVertex(vec2(2.0), vec4(0.0), ivec2(box, drawn / boxCount()));
    float near = max(kNear, 1.0e-3 * max(a.z, b.z));
    if (max(a.z, b.z) <= near) return result;  // behind the eye
    if (a.z < near) a = mix(a, b, (near - a.z) / (b.z - a.z));
    if (b.z < near) b = mix(b, a, (near - b.z) / (a.z - b.z));

    vec2 size = vec2(frame.image.xy);
    vec2 from = (0.5 + 0.5 * a.xy / a.z) * size;
    vec2 to = (0.5 + 0.5 * b.xy / b.z) * size;
    float edgeLength = length(to - from);
    vec2 along = edgeLength > 1.0e-3 ? (to - from) / edgeLength : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float border = 0.5 * lineWidth() + 1.0;
    bool atEnd = corner == 1 || corner == 3 || corner == 4;
    float side = corner == 0 || corner == 1 || corner == 3 ? -border : border;
    vec2 p = (atEnd ? to + border * along : from - border * along) + side * across;
    result.position = 2.0 * p / size - 1.0;
    result.line = vec4(atEnd ? edgeLength + border : -border, side, edgeLength,
                       atEnd ? 1.0 / b.z : 1.0 / a.z);
    return result;
}

// The box of the surface in a record, or kVeil.
int boxOfRecord(uvec4 record) {
    if (!isSurface(record)) return kVeil;
    Instance instance = fetchInstance(int(record.x));
    int box = int(boxNumber(0, int(record.x)));
    if (instance.kind == VITRINE_KIND_MESH)
        box += int(boxNumber(frame.sampling.y, instance.parameters + int(record.y)));
    return box;
}

vec4 veil(ivec2 pixel) {
    int size = int(frame.jitter.z);
    vec3 tint = vec3(0.0);
    for (int i = 0; i < size * size; i++) {
        int box = boxOfRecord(texelFetch(records, pixel * size + ivec2(i % size, i / size), 0));
        tint += box == kVeil ? vec3(0.05, 0.06, 0.08) : 0.5 * colorOfBox(box);
    }
    return vec4(tint / float(size * size), 0.5);
}

vec4 boxColor(vec2 position, vec4 line, ivec2 drawn) {
    ivec2 pixel = ivec2(position);
    if (drawn.x == kVeil) return veil(pixel);
    float beyond = max(max(-line.x, line.x - line.z), 0.0);
    float alpha = clamp(0.5 * lineWidth() + 0.5 - length(vec2(beyond, line.y)), 0.0, 1.0);
    // Boxes a few pixels wide would fill the picture with their edges.
    alpha *= clamp(line.z / (8.0 * lineWidth()), 0.2, 1.0);

    float t = 1.0 / (line.w * dot(cameraRay(position).direction, frame.cameraForward.xyz));
    int size = int(frame.jitter.z);
    uvec4 record = texelFetch(records, pixel * size + size / 2, 0);
    // Edges that lie in a surface count as before it.
    bool front = !isSurface(record) || t < 1.003 * recordDistance(record);
    if (front != (drawn.y == 1)) alpha = 0.0;
    float dash = 4.0 * lineWidth();
    if (!front) alpha *= 0.55 * clamp(0.5 + 0.5 * dash - abs(mod(line.x, 2.0 * dash) - dash), 0.0, 1.0);
    return vec4(colorOfBox(drawn.x), alpha);
}
