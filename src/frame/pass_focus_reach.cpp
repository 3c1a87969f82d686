// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void focusReachPass(PassContext& context, FocusImages& images) {
    context.run("focus_reach", {{{"extents", &images.extents}}, {}, {{"outReach", &images.reach}}});
}

}  // namespace vitrine
