// SPDX-License-Identifier: MIT
#pragma once

#include "pack/frame_block.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// Fills the camera's fields for a picture of `width` by `height` pixels.
void packCamera(const Camera& camera, int width, int height, FrameBlock& block);

}  // namespace vitrine
