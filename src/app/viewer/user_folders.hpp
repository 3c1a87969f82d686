// SPDX-License-Identifier: MIT
// Where the window may keep things of its user, after the XDG Base Directory Specification 0.8.
#pragma once

#include <filesystem>

namespace vitrine {

/// $XDG_STATE_HOME/vitrine or ~/.local/state/vitrine; empty if there is no such place.
std::filesystem::path stateFolder();
/// $XDG_CACHE_HOME/vitrine or ~/.cache/vitrine; empty if there is no such place.
std::filesystem::path cacheFolder();

/// Writes a file there, and the folders that it needs. Whether that was possible: what is kept
/// there is a help and never a need.
bool keepFile(const std::filesystem::path& file, std::string_view bytes);

}  // namespace vitrine
