// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void accumulatePass(PassContext& context, const Texture& radiance, const Texture& before,
                    Texture& after) {
    context.run("accumulate",
                {{{"radiance", &radiance}, {"meanBefore", &before}}, {}, {{"outMean", &after}}});
}

}  // namespace vitrine
