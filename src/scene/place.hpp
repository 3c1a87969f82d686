// SPDX-License-Identifier: MIT
// What nodes do to what stands on them.
#pragma once

#include "scene/scene.hpp"

namespace vitrine {

/// True if the matrix and its inverse are finite and of a size that floats can work with. Scales
/// that multiply down a chain of parents leave the range of floats, where boxes and inverses are no
/// numbers.
bool isUsablePlace(const glm::mat4& worldFromObject);

/// Puts a camera where a node is, looking along its -z with its +y up. The place is usable.
void placeOn(const glm::mat4& worldFromNode, Camera& camera);
/// The same for a light, which is not scaled.
void placeOn(const glm::mat4& worldFromNode, Light& light);

}  // namespace vitrine
