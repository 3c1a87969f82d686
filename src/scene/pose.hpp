// SPDX-License-Identifier: MIT
// A scene at a moment.
#pragma once

#include "scene/scene.hpp"

namespace vitrine {

/// The scene with all that its animations move where it is at a time, in seconds. What an animation
/// would make impossible (a camera that looks at its own eye, a light without a direction) stays as
/// the scene has it; nodes that are scaled down to nothing are not visible, nor is what they carry.
Scene poseScene(const Scene& scene, double time);

}  // namespace vitrine
