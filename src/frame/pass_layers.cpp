// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void layersPass(PassContext& context, const Texture& records, LayerTextures& layers) {
    context.block.sampling.z = 0;
    context.run(
        "layers",
        {{{"records", &records}},
         {},
         {{"outIds", &layers.ids}, {"outAlbedo", &layers.albedo}, {"outNormal", &layers.normal}}});
}

}  // namespace vitrine
