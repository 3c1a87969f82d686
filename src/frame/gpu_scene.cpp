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
    if (scene.sky == nullptr || scene.sky == uploadedSky_) return;
    const SkyMap& sky = scene.sky->map;
    std::vector<glm::vec4> nodes = sky.bright.nodes;
    nodes.insert(nodes.end(), sky.whole.nodes.begin(), sky.whole.nodes.end());
    skyTree.upload(std::as_bytes(std::span(nodes)));
    std::vector<MipTexture::Level> levels;
    for (const SkyLevel& level : sky.levels)
        levels.push_back({level.width, level.height, level.texels});
    skyPicture = MipTexture(levels);
    uploadedSky_ = scene.sky;
}

void GpuScene::update(const PackedMoment& moment) {
    slots.replaceEnd(meshSlotTexels, std::as_bytes(std::span(moment.upperSlots)));
    tables.upload(std::as_bytes(std::span(moment.tables)));
}

std::vector<std::pair<std::string, const TexelBuffer*>> GpuScene::bindings() const {
    return {{"sceneSlots", &slots},
            {"sceneTriangles", &triangles},
            {"sceneVertices", &vertices},
            {"sceneTables", &tables},
            {"skyTree", &skyTree}};
}

std::vector<std::pair<std::string, const MipTexture*>> GpuScene::pictures() const {
    return {{"skyPicture", &skyPicture}};
}

std::vector<std::pair<std::string, const TextureArray*>> GpuScene::arrays() const {
    return {{"colorPages", &colorPages}, {"dataPages", &dataPages}};
}

}  // namespace vitrine
