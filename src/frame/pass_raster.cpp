// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void rasterPass(PassContext& context, std::span<const RasterDraw> draws, const DepthImage& depth,
                Texture& records) {
    context.block.sampling.z = 0;
    context.draw("raster", {{}, {"outRecord", &records}, {}, &depth}, draws);
}

}  // namespace vitrine
