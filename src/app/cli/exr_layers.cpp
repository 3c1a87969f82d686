// SPDX-License-Identifier: MIT
#include "app/cli/exr_layers.hpp"

namespace vitrine {

std::vector<uint8_t> encodeLayers(const LayerImages& layers, const ExrText& text) {
    std::vector<ExrChannel> channels;
    const auto add = [&](std::vector<std::string> names, const auto& image, ExrReal real) {
        const std::span all(image.pixels);
        const size_t stride = image.pixels.size() / image.pixelCount();
        for (size_t c = 0; c < names.size(); ++c)
            channels.push_back({std::move(names[c]), all.subspan(c), stride, real});
    };
    add({"R", "G", "B"}, layers.light, ExrReal::kFloat);
    add({"albedo.R", "albedo.G", "albedo.B"}, layers.albedo, ExrReal::kHalf);
    add({"normal.X", "normal.Y", "normal.Z"}, layers.normal, ExrReal::kHalf);
    add({"depth.Z"}, layers.depth, ExrReal::kFloat);
    add({"id.instance", "id.primitive", "id.material"}, layers.ids, ExrReal::kFloat);
    return encodeExr({layers.light.width, layers.light.height}, channels, text);
}

}  // namespace vitrine
