// SPDX-License-Identifier: MIT
// The animations of a model as tracks of a scene.
#pragma once

#include <vector>

#include "gltf/model.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// The animation that plays unless another is asked for: the first that moves nodes, or kNoIndex.
int firstAnimation(const GltfModel& model);

/// The one that a node of the scene chooses of its model, or kNoIndex. Says which others there are.
int chosenAnimation(const GltfModel& model, const Node& root, Diagnostics& diagnostics);

/// Numbers in the keys of an animation; a file can be included many times.
size_t sizeOf(const GltfAnimation& animation);

/// Tracks of all its channels, which repeat together from 0 to the animation's duration.
/// `sceneNode`: the index in Scene::nodes of each node of the file; nodes without one are left out.
std::vector<AnimationTrack> tracksOf(const GltfAnimation& animation,
                                     const std::vector<std::optional<size_t>>& sceneNode,
                                     const SourceLocation& where);

/// The box around all of the scene to show while its first animation plays, by samples of it: at
/// rest if there is none.
Aabb boundsOverTime(const GltfModel& model);

}  // namespace vitrine
