// SPDX-License-Identifier: MIT
// Animations of nodes.
#pragma once

#include "gltf/accessor.hpp"
#include "gltf/read_context.hpp"

namespace vitrine {

/// Fills model.animations; the nodes must have been read.
void readAnimations(ReadContext& context, const Accessors& accessors);

}  // namespace vitrine
