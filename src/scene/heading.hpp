// SPDX-License-Identifier: MIT
// What a scene says of itself, without reading the rest of it.
#pragma once

#include <filesystem>
#include <string>

namespace vitrine {

struct SceneHeading {
    std::string title, description;
};

/// Of the file's own `[scene]`; empty where it says nothing, or cannot be read.
SceneHeading readHeading(const std::filesystem::path& file);

}  // namespace vitrine
