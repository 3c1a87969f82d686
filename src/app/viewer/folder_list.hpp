// SPDX-License-Identifier: MIT
// What a folder holds that the window can open.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {

struct FolderList {
    std::vector<std::string> folders, files;  ///< by name; hidden ones are left out
    std::string problem;                      ///< why there are none, or not all
};
FolderList listFolder(const std::filesystem::path& folder);

/// The path that somebody has typed in a folder: "~" is home, what is relative is in the folder.
std::filesystem::path typedPath(const std::filesystem::path& folder, const std::string& text);

}  // namespace vitrine
