// SPDX-License-Identifier: MIT
// What one section of a scene says of another: names, and parents.
#pragma once

#include "scene/scene.hpp"

namespace vitrine {

/// Reports names that nothing has, names that two things have, and nodes that are their own
/// ancestors; those lose their parent.
void checkReferences(Scene& scene, Diagnostics& diagnostics);

}  // namespace vitrine
