// SPDX-License-Identifier: MIT
// One step down a four-wide tree with quantised boxes (after Ylitie, Karras, Laine 2017, and
// Mahovsky 2005): three texels hold the boxes of all children, each plane in 8 bits relative to the
// node's box, rounded outwards. pack/bvh_layout.hpp writes what this reads.
//
//   a.xyz  lower corner of the node's box, float bits     a.w  exponents of the grid, 3 x 8 bits
//   b      lower x, upper x, lower y, upper y: one byte a child
//   c.xy   lower z, upper z     c.z  first slot of the children's block
//   c.w    one byte a child: 0 for none, else 1 + its offset in the block, 0x80 for a leaf
#include "scene/fetch.glsl"
#if HAS_CONES
#include "trace/cone.glsl"
#endif

vec4 bytesOf(uint word) { return vec4(uvec4(word, word >> 8u, word >> 16u, word >> 24u) & 255u); }

const uint kNoChild = 0xffffffffu;

void sortPair(inout uint a, inout uint b) {
    uint low = min(a, b);
    b = max(a, b);
    a = low;
}

// The children that the ray meets in [0, tMax], nearest first, as keys: distance with the child's
// number in the two lowest bits; kNoChild if none. Distances are not negative, so that their bits
// sort like numbers.
// `spread`: above 0 the ray is a cone that is this wide for each unit of its length (HAS_CONES).
uvec4 intersectChildren(Slot node, vec3 origin, vec3 inverse, float tMax, float spread) {
    vec3 grid = uintBitsToFloat((uvec3(node.a.w, node.a.w >> 8u, node.a.w >> 16u) & 255u) << 23u);
    vec3 slope = grid * inverse;
    vec3 start = (uintBitsToFloat(node.a.xyz) - origin) * inverse;
    // Four roundings of each plane's distance, bounded by the two terms' sizes: the boxes stay
    // conservative even where the terms cancel (Ize 2013).
    vec3 slack = 4.0e-7 * (abs(start) + 255.0 * abs(slope));
#if HAS_CONES
    vec3 low = uintBitsToFloat(node.a.xyz) - origin;
    float farthest = length(max(abs(low), abs(low + 255.0 * grid)));
    slack += coneRadius(spread, farthest, tMax) * abs(inverse);
#endif
    vec3 near = start - slack;
    vec3 far = start + slack;
    bvec3 forward = greaterThanEqual(inverse, vec3(0.0));
    vec4 tNear = max(max(bytesOf(forward.x ? node.b.x : node.b.y) * slope.x + near.x,
                         bytesOf(forward.y ? node.b.z : node.b.w) * slope.y + near.y),
                     max(bytesOf(forward.z ? node.c.x : node.c.y) * slope.z + near.z, vec4(0.0)));
    vec4 tFar = min(min(bytesOf(forward.x ? node.b.y : node.b.x) * slope.x + far.x,
                        bytesOf(forward.y ? node.b.w : node.b.z) * slope.y + far.y),
                    min(bytesOf(forward.z ? node.c.y : node.c.x) * slope.z + far.z, vec4(tMax)));
    uvec4 present = uvec4(node.c.w, node.c.w >> 8u, node.c.w >> 16u, node.c.w >> 24u) & 255u;
    uvec4 keys = (floatBitsToUint(tNear) & ~3u) | uvec4(0u, 1u, 2u, 3u);
    keys.x = tNear.x <= tFar.x && present.x != 0u ? keys.x : kNoChild;
    keys.y = tNear.y <= tFar.y && present.y != 0u ? keys.y : kNoChild;
    keys.z = tNear.z <= tFar.z && present.z != 0u ? keys.z : kNoChild;
    keys.w = tNear.w <= tFar.w && present.w != 0u ? keys.w : kNoChild;
    sortPair(keys.x, keys.y);
    sortPair(keys.z, keys.w);
    sortPair(keys.x, keys.z);
    sortPair(keys.y, keys.w);
    sortPair(keys.y, keys.z);
    return keys;
}

// The slot of the child a key names, with VITRINE_LEAF_BIT if it is a leaf.
uint childOf(Slot node, uint key) {
    uint entry = node.c.w >> ((key & 3u) * 8u);
    return (node.c.z + (entry & 127u) - 1u) | ((entry & 128u) << 24u);
}
