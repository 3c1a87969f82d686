// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void bouncePass(PassContext& context, const PathImages& from, PathImages& to) {
    context.run("bounce", {{{"records", &from.records},
                            {"pathOrigin", &from.origin},
                            {"pathDirection", &from.direction},
                            {"pathThroughput", &from.throughput}},
                           {},
                           {{"outRecord", &to.records},
                            {"outOrigin", &to.origin},
                            {"outDirection", &to.direction},
                            {"outThroughput", &to.throughput}}});
    context.block.sampling.z += 1;
}

}  // namespace vitrine
