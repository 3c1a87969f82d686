// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void focusLevelsPass(PassContext& context, const Texture& mean, const Texture& records,
                     FocusImages& images) {
    context.run("focus_levels", {{{"mean", &mean}, {"records", &records}},
                                 {},
                                 {{"outLevels", &images.levels}, {"outExtents", &images.extents}}});
}

}  // namespace vitrine
