// SPDX-License-Identifier: MIT
// For the tests of this folder: the slots read back as shaders/trace/node.glsl and trace.glsl read
// them, line by line. The boxes are the shader's; the triangle test is that of bvh/triangle.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <span>
#include <vector>

#include "bvh/triangle.hpp"
#include "pack/bvh_layout.hpp"
#include "shared/limits.glsl"

namespace vitrine::test {

struct Slot {
    glm::uvec4 a, b, c;
};

inline Slot fetchSlot(const std::vector<glm::uvec4>& texels, uint32_t slot) {
    const size_t i = static_cast<size_t>(slot) * VITRINE_SLOT_TEXELS;
    return {texels.at(i), texels.at(i + 1), texels.at(i + 2)};
}

inline float asFloat(uint32_t bits) {
    return std::bit_cast<float>(bits);
}
inline glm::vec3 asFloats(const glm::uvec4& v) {
    return {asFloat(v.x), asFloat(v.y), asFloat(v.z)};
}
inline uint32_t byteOf(uint32_t word, int i) {
    return (word >> (8 * i)) & 255u;
}

inline QuantisedNode nodeOf(const Slot& s) {
    return {asFloats(s.a),
            {byteOf(s.a.w, 0), byteOf(s.a.w, 1), byteOf(s.a.w, 2)},
            {s.b.x, s.b.z, s.c.x},
            {s.b.y, s.b.w, s.c.y}};
}

/// The slot of a child, with VITRINE_LEAF_BIT if it is a leaf.
inline uint32_t childOf(const Slot& s, int child) {
    const uint32_t entry = byteOf(s.c.w, child);
    return (s.c.z + (entry & 127u) - 1u) | ((entry & 128u) << 24u);
}

/// visit(slot, box, stack) for every leaf; `stack` is how many entries the worst ray has pushed
/// when it stands there.
inline void forEachLeaf(const std::vector<glm::uvec4>& texels, uint32_t root,
                        const std::function<void(uint32_t, const Aabb&, int)>& visit) {
    struct Entry {
        uint32_t slot;
        Aabb box;
        int stack;
    };
    std::vector<Entry> pending{{root, {}, 0}};
    while (!pending.empty()) {
        const Entry at = pending.back();
        pending.pop_back();
        if ((at.slot & VITRINE_LEAF_BIT) != 0) {
            visit(at.slot & ~VITRINE_LEAF_BIT, at.box, at.stack);
            continue;
        }
        const Slot slot = fetchSlot(texels, at.slot);
        int children = 0;
        for (int i = 0; i < 4; ++i) children += byteOf(slot.c.w, i) != 0 ? 1 : 0;
        for (int i = 0; i < 4; ++i)
            if (byteOf(slot.c.w, i) != 0)
                pending.push_back(
                    {childOf(slot, i), dequantise(nodeOf(slot), i), at.stack + children - 1});
    }
}

/// visit(triangle, corners, box of its leaf, stack)
inline void forEachTriangle(
    const std::vector<glm::uvec4>& texels, uint32_t root,
    const std::function<void(uint32_t, const std::array<glm::vec3, 3>&, const Aabb&, int)>& visit) {
    forEachLeaf(texels, root, [&](uint32_t first, const Aabb& box, int stack) {
        for (uint32_t slot = first;; ++slot) {
            const Slot s = fetchSlot(texels, slot);
            visit(s.a.w & ~VITRINE_LAST_TRIANGLE_BIT, {asFloats(s.a), asFloats(s.b), asFloats(s.c)},
                  box, stack);
            if ((s.a.w & VITRINE_LAST_TRIANGLE_BIT) != 0) break;
        }
    });
}

inline glm::vec3 safeInverse(const glm::vec3& d) {
    glm::vec3 result;
    for (int i = 0; i < 3; ++i) result[i] = 1 / (std::abs(d[i]) < 1e-18f ? 1e-18f : d[i]);
    return result;
}

/// Distance to the children that the ray meets in [0, tMax], with their numbers, nearest first.
inline std::vector<std::pair<float, int>> intersectChildren(const Slot& slot,
                                                            const glm::vec3& origin,
                                                            const glm::vec3& inverse, float tMax) {
    const QuantisedNode node = nodeOf(slot);
    std::vector<std::pair<float, int>> met;
    for (int child = 0; child < 4; ++child) {
        if (byteOf(slot.c.w, child) == 0) continue;
        float tNear = 0, tFar = tMax;
        for (int axis = 0; axis < 3; ++axis) {
            const float slope = asFloat(node.exponents[axis] << 23) * inverse[axis];
            const float start = (node.origin[axis] - origin[axis]) * inverse[axis];
            const float slack = 4e-7f * (std::abs(start) + 255 * std::abs(slope));
            const auto low = static_cast<float>(byteOf(node.low[axis], child));
            const auto high = static_cast<float>(byteOf(node.high[axis], child));
            const bool forward = inverse[axis] >= 0;
            tNear = std::max(tNear, (forward ? low : high) * slope + (start - slack));
            tFar = std::min(tFar, (forward ? high : low) * slope + (start + slack));
        }
        if (tNear <= tFar) met.emplace_back(tNear, child);
    }
    std::sort(met.begin(), met.end());
    return met;
}

struct SlotHit {
    bool hit = false;
    float t = 0;
    uint32_t triangle = 0;
    int stack = 0;  ///< most entries at a time
};

inline SlotHit walkSlots(const std::vector<glm::uvec4>& texels, uint32_t root, const Ray& ray) {
    SlotHit result;
    float best = ray.tMax;
    const ShearedRay sheared(ray);
    const glm::vec3 inverse = safeInverse(ray.direction);
    std::vector<uint32_t> stack;
    uint32_t current = root;
    while (true) {
        const Slot slot = fetchSlot(texels, current & ~VITRINE_LEAF_BIT);
        bool pop = false;
        if ((current & VITRINE_LEAF_BIT) == 0) {
            const auto met = intersectChildren(slot, ray.origin, inverse, best);
            for (size_t i = met.size(); i-- > 1;) stack.push_back(childOf(slot, met[i].second));
            result.stack = std::max(result.stack, static_cast<int>(stack.size()));
            pop = met.empty();
            if (!pop) current = childOf(slot, met[0].second);
        } else {
            const auto hit =
                intersectLine(sheared, asFloats(slot.a), asFloats(slot.b), asFloats(slot.c));
            if (hit && hit->t >= 0 && hit->t < best) {
                best = hit->t;
                result = {true, hit->t, slot.a.w & ~VITRINE_LAST_TRIANGLE_BIT, result.stack};
            }
            pop = (slot.a.w & VITRINE_LAST_TRIANGLE_BIT) != 0;
            ++current;
        }
        if (!pop) continue;
        if (stack.empty()) return result;
        current = stack.back();
        stack.pop_back();
    }
}

}  // namespace vitrine::test
