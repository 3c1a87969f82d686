// SPDX-License-Identifier: MIT
// Embree's builder alone (rtcBuildBVH, MEDIUM) making a binary tree of our node layout: the peer
// that neither copies triangles nor writes a wide tree.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
#include <new>
#include <span>
#include <vector>

#include "base/aabb.hpp"

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

/// Destroys the order of `primitives`.
inline void* embreeBuildBinary(RTCBVH bvh, std::vector<RTCBuildPrimitive>& primitives) {
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = 64;
    arguments.sahBlockSize = 1;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = 4;
    arguments.bvh = bvh;
    arguments.primitives = primitives.data();
    arguments.primitiveCount = primitives.size();
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
        return leaf;
    };
    return rtcBuildBVH(&arguments);
}

}  // namespace vitrine
