// SPDX-License-Identifier: MIT
// The names and types of the layers in the EXR files that `render` writes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frame/layers.hpp"
#include "image/exr.hpp"

namespace vitrine {

/// R, G, B; albedo.R, .G, .B; normal.X, .Y, .Z; depth.Z; id.instance, .primitive, .material.
std::vector<uint8_t> encodeLayers(const LayerImages& layers, const ExrText& text);

}  // namespace vitrine
