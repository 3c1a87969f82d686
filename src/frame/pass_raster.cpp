// SPDX-License-Identifier: MIT
#include <algorithm>

#include "frame/in_view.hpp"
#include "frame/passes.hpp"
#include "pack/camera.hpp"

namespace vitrine {
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
        // Things stand on grounds that are larger than they: what ends nearest most likely hides
        // the rest.
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
