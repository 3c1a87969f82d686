// SPDX-License-Identifier: MIT
// Embree's builder alone (rtcBuildBVH) making a binary tree: the peer that neither copies triangles
// nor writes a wide tree. Its tree as ours, to be measured and walked like ours.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <span>
#include <vector>

#include "bvh/bvh.hpp"
#include "bvh/clip.hpp"

namespace vitrine {

struct EmbreeBinaryNode {
    Aabb boxes[2];
    void* children[2];
};

inline std::vector<RTCBuildPrimitive> embreePrimitives(std::span<const glm::vec3> positions,
                                                       std::span<const glm::uvec3> triangles) {
    std::vector<RTCBuildPrimitive> result;
    result.reserve(triangles.size());
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        Aabb box;
        for (int corner = 0; corner < 3; ++corner) box.grow(positions[triangles[i][corner]]);
        result.push_back({box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, i});
    }
    return result;
}

/// The mesh whose triangles HIGH quality cuts.
struct EmbreeMesh {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

inline void embreeSplit(const RTCBuildPrimitive* primitive, unsigned axis, float plane,
                        RTCBounds* left, RTCBounds* right, void* user) {
    const auto& mesh = *static_cast<const EmbreeMesh*>(user);
    const glm::uvec3& t = mesh.triangles[primitive->primID];
    const RTCBuildPrimitive& p = *primitive;
    const Aabb box{{p.lower_x, p.lower_y, p.lower_z}, {p.upper_x, p.upper_y, p.upper_z}};
    const ClippedBoxes parts = clip({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]},
                                    box, int(axis), plane);
    const auto store = [](const Aabb& b, RTCBounds* out) {
        *out = {b.min.x, b.min.y, b.min.z, 0, b.max.x, b.max.y, b.max.z, 0};
    };
    store(parts.left, left);
    store(parts.right, right);
}

/// Leaves are marked by the lowest bit of their address.
inline constexpr uintptr_t kEmbreeLeaf = 1;

/// Destroys the order of `primitives`. `mesh` is needed for HIGH quality.
inline void* embreeBuildBinary(RTCBVH bvh, std::vector<RTCBuildPrimitive>& primitives,
                               RTCBuildQuality quality = RTC_BUILD_QUALITY_MEDIUM,
                               EmbreeMesh* mesh = nullptr) {
    const size_t given = primitives.size();
    if (quality == RTC_BUILD_QUALITY_HIGH) primitives.resize(2 * given);
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = quality;
    arguments.splitPrimitive = mesh != nullptr ? embreeSplit : nullptr;
    arguments.userPtr = mesh;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = 64;
    arguments.sahBlockSize = 1;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = 4;
    arguments.bvh = bvh;
    arguments.primitives = primitives.data();
    arguments.primitiveCount = given;
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = [](RTCThreadLocalAllocator allocator, unsigned, void*) -> void* {
        return new (rtcThreadLocalAlloc(allocator, sizeof(EmbreeBinaryNode), 16)) EmbreeBinaryNode;
    };
    arguments.setNodeChildren = [](void* node, void** children, unsigned count, void*) {
        for (unsigned i = 0; i < count; ++i)
            static_cast<EmbreeBinaryNode*>(node)->children[i] = children[i];
    };
    arguments.setNodeBounds = [](void* node, const RTCBounds** bounds, unsigned count, void*) {
        for (unsigned i = 0; i < count; ++i) {
            const RTCBounds& b = *bounds[i];
            static_cast<EmbreeBinaryNode*>(node)->boxes[i] = {{b.lower_x, b.lower_y, b.lower_z},
                                                              {b.upper_x, b.upper_y, b.upper_z}};
        }
    };
    arguments.createLeaf = [](RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* items,
                              size_t count, void*) -> void* {
        auto* leaf = static_cast<uint32_t*>(
            rtcThreadLocalAlloc(allocator, (count + 1) * sizeof(uint32_t), 16));
        leaf[0] = uint32_t(count);
        for (size_t i = 0; i < count; ++i) leaf[i + 1] = items[i].primID;
        return reinterpret_cast<void*>(reinterpret_cast<uintptr_t>(leaf) | kEmbreeLeaf);
    };
    return rtcBuildBVH(&arguments);
}

/// The tree as ours.
inline void convertEmbree(void* from, const Aabb& box, uint32_t slot, Bvh& out) {
    const auto address = reinterpret_cast<uintptr_t>(from);
    if ((address & kEmbreeLeaf) != 0) {
        const auto* leaf = reinterpret_cast<const uint32_t*>(address & ~kEmbreeLeaf);
        out.nodes[slot] = {box.min, uint32_t(out.items.size()), box.max, leaf[0]};
        out.items.insert(out.items.end(), leaf + 1, leaf + 1 + leaf[0]);
        return;
    }
    const auto& node = *static_cast<const EmbreeBinaryNode*>(from);
    const auto pair = uint32_t(out.nodes.size());
    out.nodes[slot] = {box.min, pair, box.max, 0};
    out.nodes.resize(pair + 2);
    for (uint32_t i = 0; i < 2; ++i) convertEmbree(node.children[i], node.boxes[i], pair + i, out);
}

}  // namespace vitrine
