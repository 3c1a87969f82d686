// SPDX-License-Identifier: MIT
// Reads a scene file. Everything wrong with it is reported in one run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace vitrine {

/// `file` is for messages and gives the folder that references are relative to. `overrides` are
/// `--set` assignments. Errors go to `diagnostics`; the scene returned is as complete as possible,
/// so that later stages can find more of them.
Scene parseScene(std::string_view text, const std::string& file,
                 const std::vector<std::string>& overrides, Diagnostics& diagnostics);

/// Reads the file and parses it. Throws InputError if it cannot be read.
Scene loadScene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                Diagnostics& diagnostics);

}  // namespace vitrine
