// SPDX-License-Identifier: MIT
// What only the snippets know of a scene's animations.
#pragma once

#include "pack/assets.hpp"

namespace vitrine {

/// Animated parameters that a snippet does not have, or keys that do not fit them, are errors.
void checkAnimations(const Scene& scene, const Assets& assets, Diagnostics& diagnostics);

}  // namespace vitrine
