// SPDX-License-Identifier: MIT
// Images and textures.
#pragma once

#include "gltf/buffers.hpp"
#include "gltf/read_context.hpp"

namespace vitrine {

/// Fills model.images and model.textures.
void readTextures(ReadContext& context, const Buffers& buffers);

}  // namespace vitrine
