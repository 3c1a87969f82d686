// SPDX-License-Identifier: MIT
// Materials and their extensions.
#pragma once

#include "gltf/read_context.hpp"

namespace vitrine {

/// Fills model.materials; the textures must have been read.
void readMaterials(ReadContext& context);

}  // namespace vitrine
