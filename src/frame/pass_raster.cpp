// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "frame/passes.hpp"
#include "pack/camera.hpp"

namespace vitrine {
namespace {

/// All corners of the box lie on the wrong side of one and the same side of the view.
bool isOutside(const Aabb& box, const glm::mat4& clipFromWorld) {
    std::array<int, 4> beyond{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p((corner & 1) != 0 ? box.max.x : box.min.x,
                          (corner & 2) != 0 ? box.max.y : box.min.y,
                          (corner & 4) != 0 ? box.max.z : box.min.z);
        const glm::vec4 clip = clipFromWorld * glm::vec4(p, 1);
        // Also right for corners behind the eye, where w is negative.
        beyond[0] += clip.x < -clip.w;
        beyond[1] += clip.x > clip.w;
        beyond[2] += clip.y < -clip.w;
        beyond[3] += clip.y > clip.w;
    }
    return std::find(beyond.begin(), beyond.end(), 8) != beyond.end();
}

/// Things stand on grounds that are larger than they: what ends nearest most likely hides the rest.
float farthestDistance(const Aabb& box, const glm::vec3& eye) {
    return glm::length(glm::max(glm::abs(box.min - eye), glm::abs(box.max - eye)));
}

}  // namespace

std::vector<RasterDraw> rasterDraws(PassContext& context,
                                    std::span<const PackedInstance> instances) {
    const FrameBlock& block = context.block;
    const RasterOrder& triangles = context.rasterOrder(instances);
    const glm::mat4 clipFromWorld = packProjection(block);
    const glm::vec3 eye(block.cameraEye);
    std::vector<std::pair<float, RasterDraw>> order;
    for (size_t i = 0; i < instances.size(); ++i) {
        const PackedInstance& instance = instances[i];
        if (instance.field || isOutside(instance.worldBox, clipFromWorld)) continue;
        RasterOrder::Ranges ranges = triangles.ranges(instance, eye);
        const float distance = farthestDistance(instance.worldBox, eye);
        for (const bool culled : {true, false}) {
            std::vector<RasterRange>& list = culled ? ranges.culled : ranges.whole;
            if (list.empty()) continue;
            order.push_back({distance,
                             {clipFromWorld * instance.worldFromObject, static_cast<int>(i),
                              instance.firstTriangle, std::move(list), culled,
                              glm::determinant(glm::mat3(instance.worldFromObject)) < 0}});
        }
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<RasterDraw> draws;
    for (auto& [distance, draw] : order) draws.push_back(std::move(draw));
    return draws;
}

void rasterPass(PassContext& context, std::span<const RasterDraw> draws, const DepthImage& depth,
                Texture& records) {
    context.block.sampling.z = 0;
    context.draw("raster", {{}, {"outRecord", &records}, {}, &depth}, draws);
}

}  // namespace vitrine
