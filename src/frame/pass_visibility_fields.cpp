// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void visibilityFieldsPass(PassContext& context, int fieldRoot, const Texture& meshes,
                          Texture& records) {
    const int root = std::exchange(context.block.counts.z, fieldRoot);
    context.run("visibility_fields", {{{"records", &meshes}}, {}, {{"outRecord", &records}}});
    context.block.counts.z = root;
}

}  // namespace vitrine
