// SPDX-License-Identifier: MIT
#include "frame/gpu_scene.hpp"

namespace vitrine {

void GpuScene::upload(const PackedScene& scene) {
    slots.upload(std::as_bytes(std::span(scene.slots)));
    triangles.upload(std::as_bytes(std::span(scene.triangles)));
    vertices.upload(std::as_bytes(std::span(scene.vertices)));
    tables.upload(std::as_bytes(std::span(scene.tables)));
}

std::vector<std::pair<std::string, const TexelBuffer*>> GpuScene::bindings() const {
    return {{"sceneSlots", &slots},
            {"sceneTriangles", &triangles},
            {"sceneVertices", &vertices},
            {"sceneTables", &tables}};
}

}  // namespace vitrine
