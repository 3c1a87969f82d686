// SPDX-License-Identifier: MIT
// Nodes and scenes, and what hangs on nodes besides meshes: cameras and lights.
#pragma once

#include "gltf/read_context.hpp"

namespace vitrine {

void readCameras(ReadContext& context);
void readLights(ReadContext& context);

/// Fills model.nodes, nodeOrder, scenes and scene; meshes, cameras and lights must have been read.
/// False, with an error, if the nodes are no trees: then nodeOrder does not hold all of them.
bool readNodes(ReadContext& context);

/// Marks nodes that cannot be drawn, and all below them, as skipped; one warning a cause. Needs the
/// animations: a node of size zero may grow.
void skipUnusableNodes(ReadContext& context);

}  // namespace vitrine
