// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void displayPass(PassContext& context, const Texture& mean, Texture& picture) {
    context.run("display", {{{"mean", &mean}}, {}, {{"outColor", &picture}}});
}

}  // namespace vitrine
