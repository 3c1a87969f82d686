// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void focusPass(PassContext& context, const FocusImages& images, Texture& blurred) {
    context.run(
        "focus",
        {{{"levels", &images.levels}, {"extents", &images.extents}, {"reaches", &images.reach}},
         {},
         {{"outRadiance", &blurred}}});
}

}  // namespace vitrine
