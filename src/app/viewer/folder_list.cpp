// SPDX-License-Identifier: MIT
#include "app/viewer/folder_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "app/viewer/open_scene.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

constexpr int kMostEntries = 5000;

}  // namespace

FolderList listFolder(const fs::path& folder) {
    FolderList list;
    std::error_code error;
    fs::directory_iterator entries(folder, error);
    int left = kMostEntries;
    for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
        const std::string name = entries->path().filename().string();
        if (name.front() == '.') continue;
        if (left-- == 0) {
            list.problem = fmt::format("only the first {} are shown", kMostEntries);
            break;
        }
        std::error_code unknown;  // a link that leads nowhere is neither
        if (entries->is_directory(unknown))
            list.folders.push_back(name);
        else if (canOpen(name) && entries->is_regular_file(unknown))
            list.files.push_back(name);
    }
    if (error) list.problem = error.message();
    std::sort(list.folders.begin(), list.folders.end());
    std::sort(list.files.begin(), list.files.end());
    return list;
}

fs::path typedPath(const fs::path& folder, const std::string& text) {
    const char* home = std::getenv("HOME");
    if (home != nullptr && (text == "~" || text.rfind("~/", 0) == 0))
        return (home + text.substr(1));
    return (folder / text).lexically_normal();
}

}  // namespace vitrine
