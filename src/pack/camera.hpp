// SPDX-License-Identifier: MIT
#pragma once

#include "pack/frame_block.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// Fills the camera's fields for a picture of `width` by `height` pixels.
void packCamera(const Camera& camera, int width, int height, FrameBlock& block);

/// `clipFromWorld` of the camera and the sample offset in the block. Depth is reversed with an
/// infinite far plane: 1 at the near plane, a millimetre before the eye, 0 at infinity.
glm::mat4 packProjection(const FrameBlock& block);

/// Where sample `index` of `count` looks, from the pixel's centre, in pixels. One sample looks
/// through the middle; more are spread by a tent filter, two pixels wide.
glm::vec2 sampleOffset(int index, int count);

}  // namespace vitrine
