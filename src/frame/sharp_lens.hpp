// SPDX-License-Identifier: MIT
#pragma once

#include "pack/frame_block.hpp"

namespace vitrine {

/// For as long as it lives all is sharp: data and lines are not blurred.
class SharpLens {
  public:
    explicit SharpLens(FrameBlock& block) : block_(block), radius_(block.lens.x) {
        block.lens.x = 0;
    }
    ~SharpLens() { block_.lens.x = radius_; }
    SharpLens(const SharpLens&) = delete;
    SharpLens& operator=(const SharpLens&) = delete;

  private:
    FrameBlock& block_;
    float radius_;
};

}  // namespace vitrine
