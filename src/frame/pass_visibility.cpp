// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void visibilityPass(PassContext& context, Texture& records) {
    context.block.sampling.z = 0;
    context.run("visibility", {{}, {}, {{"outRecord", &records}}});
}

}  // namespace vitrine
