// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void lightPass(PassContext& context, const PathImages& path, const Texture& before,
               Texture& after) {
    context.run("light", {{{"records", &path.records},
                           {"pathOrigin", &path.origin},
                           {"pathDirection", &path.direction},
                           {"pathThroughput", &path.throughput},
                           {"radianceBefore", &before}},
                          {},
                          {{"outRadiance", &after}}});
}

}  // namespace vitrine
