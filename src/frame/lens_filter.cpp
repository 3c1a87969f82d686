// SPDX-License-Identifier: MIT
#include "frame/lens_filter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "frame/passes.hpp"

namespace vitrine {

LensFilter::LensFilter(const PassContext& context, int width, int height, int maxSide) {
    constexpr int kTile = 16;
    const auto part = [](int size, int side) { return (size + side - 1) / side; };
    int stacked = 0;
    for (const int side : {2, 4, 8, kTile}) stacked += part(height, side);
    const int atlasWidth = width + part(width, 2), atlasHeight = std::max(height, stacked);
    if (std::max(atlasWidth, atlasHeight) > maxSide)
        throw MachineError(
            fmt::format("camera.lens = \"filter\" needs an image of {}x{} pixels; "
                        "this driver allows {} a side",
                        atlasWidth, atlasHeight, maxSide));
    images_.levels = context.image(atlasWidth, atlasHeight, TexelFormat::kRgba32f);
    images_.extents = context.image(atlasWidth, atlasHeight, TexelFormat::kRgba32f);
    images_.reach = context.image(part(width, kTile), part(height, kTile), TexelFormat::kRgba32f);
    blurred_ = context.image(width, height, TexelFormat::kRgba32f);
}

void LensFilter::prepare(PassContext& context, const Texture& mean, const Texture& records) {
    focusLevelsPass(context, mean, records, images_);
    focusReachPass(context, images_);
}

void LensFilter::blur(PassContext& context) {
    focusPass(context, images_, blurred_);
}

}  // namespace vitrine
