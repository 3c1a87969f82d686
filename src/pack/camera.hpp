// SPDX-License-Identifier: MIT
#pragma once

#include "pack/frame_block.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// Fills the camera's fields for a picture of `width` by `height` pixels. The lens is thin and does
/// not breathe: the field of view is that of the focal length, whatever the distance in focus. A
/// point at distance d along the axis becomes a disc of 2 r |d - f| / (d f) of the image plane at
/// distance 1, where r is the radius of the lens and f the distance in focus.
void packCamera(const Camera& camera, int width, int height, FrameBlock& block);

/// `clipFromWorld` of the camera and the sample offset in the block. Depth is reversed with an
/// infinite far plane: 1 at the near plane, a millimetre before the eye, 0 at infinity.
glm::mat4 packProjection(const FrameBlock& block);

/// Where sample `index` of `count` looks, from the pixel's centre, in pixels. One sample looks
/// through the middle; more are spread by a tent filter, two pixels wide.
glm::vec2 sampleOffset(int index, int count);

}  // namespace vitrine
