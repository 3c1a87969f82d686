// SPDX-License-Identifier: MIT
// Source: glTF 2.0 Specification, section 3.7.2.1, "Overview" (of primitives).
#include "gltf/triangle_indices.hpp"

namespace vitrine {

uint64_t triangleCount(PrimitiveMode mode, uint64_t corners) {
    if (mode == PrimitiveMode::kTriangles) return corners / 3;
    return corners < 3 ? 0 : corners - 2;
}

std::vector<glm::uvec3> toTriangles(PrimitiveMode mode, const std::vector<uint32_t>& corners) {
    std::vector<glm::uvec3> triangles;
    const uint64_t count = triangleCount(mode, corners.size());
    triangles.reserve(count);
    for (size_t i = 0; i < count; ++i) {
        glm::uvec3 v;
        if (mode == PrimitiveMode::kTriangles)
            v = {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
        else if (mode == PrimitiveMode::kTriangleFan)
            v = {corners[i + 1], corners[i + 2], corners[0]};
        else  // every second one of a strip would wind the other way
            v = {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]};
        // Strips are stitched together by triangles that use a vertex twice: meant to be invisible.
        const bool isStitch = v.x == v.y || v.y == v.z || v.z == v.x;
        if (mode == PrimitiveMode::kTriangles || !isStitch) triangles.push_back(v);
    }
    return triangles;
}

}  // namespace vitrine
