// SPDX-License-Identifier: MIT
// [[camera]]: where a camera stands, or the way that it goes by itself.
#pragma once

#include <toml++/toml.h>

#include <vector>

#include "scene/scene.hpp"

namespace vitrine {

/// Reads the table of what will be Scene::cameras[index]. `ways` gets the tracks of its `orbit` or
/// `path`; where it stands at their beginning is where the camera stands. What `--set` says of eye
/// and target is left as it is.
Camera readCamera(const toml::table& table, size_t index, std::vector<AnimationTrack>& ways,
                  Diagnostics& diagnostics);

}  // namespace vitrine
