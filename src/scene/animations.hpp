// SPDX-License-Identifier: MIT
// Reads the [[animation]] tables of a document into the tracks of its scene.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace vitrine {

/// The rest of `scene` has been read. `ways` are tracks that it has anyhow, `tables` may be
/// nullptr. What `overrides` (`--set` assignments) give is not animated.
void readAnimations(const toml::array* tables, std::vector<AnimationTrack> ways,
                    const std::vector<std::string>& overrides, Scene& scene,
                    Diagnostics& diagnostics);

}  // namespace vitrine
