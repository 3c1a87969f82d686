// SPDX-License-Identifier: MIT
// Where a glTF model's nodes are, at rest and at a time.
#pragma once

#include <vector>

#include "gltf/model.hpp"

namespace vitrine {

/// `parentFromNode` of every node as the file gives it.
std::vector<glm::mat4> restPose(const GltfModel& model);

/// `parentFromNode` of every node at a time in seconds. Before the first and after the last key of
/// a channel its value stays; what no channel moves is at rest.
std::vector<glm::mat4> sampleAnimation(const GltfModel& model, int animation, float time);

/// `worldFromNode` of every node, of its `parentFromNode`.
std::vector<glm::mat4> worldFromNodes(const GltfModel& model,
                                      const std::vector<glm::mat4>& parentFromNodes);

/// The nodes to draw: all below a scene's roots that are not skipped, parents first.
std::vector<int> nodesOfScene(const GltfModel& model, int scene);

}  // namespace vitrine
