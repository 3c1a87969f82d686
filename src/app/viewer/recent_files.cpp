// SPDX-License-Identifier: MIT
#include "app/viewer/recent_files.hpp"

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

#include "app/viewer/open_scene.hpp"
#include "app/viewer/user_folders.hpp"
#include "base/error.hpp"
#include "base/file.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kMaxListBytes = 64u << 10;
constexpr size_t kLongestPath = 4096;

bool isThere(const std::string& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);
}

}  // namespace

std::vector<std::string> recentFilesOf(std::string_view text) {
    std::vector<std::string> files;
    std::istringstream lines{std::string(text)};
    std::string line;
    while (files.size() < RecentFiles::kMost && std::getline(lines, line)) {
        const bool plain = std::none_of(line.begin(), line.end(),
                                        [](unsigned char c) { return c < 0x20 || c == 0x7f; });
        if (!plain || line.size() > kLongestPath || !fs::path(line).is_absolute()) continue;
        if (canOpen(line) && std::find(files.begin(), files.end(), line) == files.end())
            files.push_back(line);
    }
    return files;
}

RecentFiles::RecentFiles(fs::path list) : list_(std::move(list)) {
    refresh();
}

std::vector<std::string> RecentFiles::read() const {
    if (list_.empty()) return files_;
    try {
        return recentFilesOf(readFile(list_, kMaxListBytes));
    } catch (const InputError&) {
        return files_;
    }
}

void RecentFiles::refresh() {
    files_ = read();
    std::erase_if(files_, [](const std::string& file) { return !isThere(file); });
}

void RecentFiles::add(const std::string& file) {
    std::error_code error;
    const fs::path absolute = fs::absolute(file, error).lexically_normal();
    if (error) return;
    // Another window may have added to it. A file that is missing now may be on a disk that comes
    // back.
    std::string text = absolute.string() + "\n";
    for (const std::string& known : read()) text += known + "\n";
    files_ = recentFilesOf(text);
    std::string list;
    for (const std::string& known : files_) list += known + "\n";
    if (!list_.empty()) (void)keepFile(list_, list);
    std::erase_if(files_, [](const std::string& known) { return !isThere(known); });
}

}  // namespace vitrine
