// SPDX-License-Identifier: MIT
// A level of the trees in the GPU's memory, as shaders/pass/boxes.glsl reads it.
#pragma once

#include "gpu/texture.hpp"
#include "pack/tree_level.hpp"

namespace vitrine {

class TreeBoxes {
  public:
    /// Throws MachineError if the GPU cannot hold it.
    void upload(const TreeLevel& level);

    [[nodiscard]] int count() const { return count_; }
    /// Two texels a box: low corner and instance, high corner and hue, 0 to 1, or -1 for grey.
    [[nodiscard]] const TexelBuffer& corners() const { return corners_; }
    /// Numbers, four a texel: the first box of each instance and one more, then the box of each
    /// triangle. The second part begins with a texel.
    [[nodiscard]] const TexelBuffer& numbers() const { return numbers_; }
    [[nodiscard]] int firstTriangleTexel() const { return firstTriangleTexel_; }

  private:
    TexelBuffer corners_{TexelFormat::kRgba32f};
    TexelBuffer numbers_{TexelFormat::kRgba32ui};
    int count_ = 0, firstTriangleTexel_ = 0;
};

}  // namespace vitrine
