// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void viewPass(PassContext& context, const Texture& records, Texture& radiance) {
    context.block.sampling.z = 0;
    context.run("view", {{{"records", &records}, {"counters", &context.counters[0]}},
                         {},
                         {{"outRadiance", &radiance}}});
}

}  // namespace vitrine
