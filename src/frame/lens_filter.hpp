// SPDX-License-Identifier: MIT
// Depth of field by a filter over a sharp picture (shaders/pass/focus.glsl): the images it needs
// and the order of its passes.
#pragma once

#include "frame/pass_context.hpp"

namespace vitrine {

/// What the passes of the filter hand on (shaders/shade/circles.glsl).
struct FocusImages {
    Texture levels, extents;  ///< an atlas: light with the radius of its circle; what is there
    Texture reach;            ///< one texel a tile: which bands may reach it
};

class LensFilter {
  public:
    /// For pictures of this size. Throws MachineError if `maxSide` is too small for the atlas.
    LensFilter(const PassContext& context, int width, int height, int maxSide);
    /// Takes the picture `mean` and the first hits in `records`. Needs context.block.lens.w.
    void prepare(PassContext& context, const Texture& mean, const Texture& records);
    /// Blurs it, in the rows of the context.
    void blur(PassContext& context);
    [[nodiscard]] const Texture& blurred() const { return blurred_; }

  private:
    FocusImages images_;
    Texture blurred_;
};

}  // namespace vitrine
