// SPDX-License-Identifier: MIT
// Meshes: from the primitives of a glTF file to triangles that have passed sanitizeMesh().
#pragma once

#include "gltf/accessor.hpp"
#include "gltf/read_context.hpp"

namespace vitrine {

/// Fills model.meshes; the materials must have been read.
void readMeshes(ReadContext& context, const Accessors& accessors, bool allowsQuantization);

}  // namespace vitrine
