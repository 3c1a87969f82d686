// SPDX-License-Identifier: MIT
// A scene at a moment.
#pragma once

#include "scene/scene.hpp"

namespace vitrine {

/// The scene with all that its animations move where it is at a time, in seconds. What an animation
/// would make impossible (a camera that looks at its own eye, a light without a direction) stays as
/// the scene has it. Nodes that it scales down to nothing, or out of the range of numbers, are not
/// visible, nor is what they carry; lights on them are dark.
Scene poseScene(const Scene& scene, double time);

/// Which nodes its animations move, or an ancestor of them.
std::vector<bool> movedNodes(const Scene& scene);

}  // namespace vitrine
