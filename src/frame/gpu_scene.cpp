// SPDX-License-Identifier: MIT
#include "frame/gpu_scene.hpp"

namespace vitrine {

namespace {

TextureArray uploadPages(const TextureAtlas& atlas, bool srgb) {
    std::vector<std::span<const uint8_t>> layers;
    for (const TexturePage& page : atlas.pages) layers.emplace_back(page.texels);
    return {atlas.pages.empty() ? 1 : atlas.pages[0].size, layers, srgb};
}

}  // namespace

void GpuScene::upload(const PackedScene& scene) {
    slots.upload(std::as_bytes(std::span(scene.slots)), scene.upperSlots.size());
    triangles.upload(std::as_bytes(std::span(scene.triangles)));
    vertices.upload(std::as_bytes(std::span(scene.vertices)));
    meshSlotTexels = scene.slots.size();
    update(scene);
    colorPages = uploadPages(scene.textures.color, true);
    dataPages = uploadPages(scene.textures.data, false);
}

void GpuScene::update(const PackedMoment& moment) {
    slots.replaceEnd(meshSlotTexels, std::as_bytes(std::span(moment.upperSlots)));
    tables.upload(std::as_bytes(std::span(moment.tables)));
}

std::vector<std::pair<std::string, const TexelBuffer*>> GpuScene::bindings() const {
    return {{"sceneSlots", &slots},
            {"sceneTriangles", &triangles},
            {"sceneVertices", &vertices},
            {"sceneTables", &tables}};
}

std::vector<std::pair<std::string, const TextureArray*>> GpuScene::arrays() const {
    return {{"colorPages", &colorPages}, {"dataPages", &dataPages}};
}

}  // namespace vitrine
