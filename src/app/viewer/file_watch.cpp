// SPDX-License-Identifier: MIT
#include "app/viewer/file_watch.hpp"

#include <sys/stat.h>

namespace vitrine {

FileWatch::Stamp FileWatch::stampOf(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return {};
    return {status.st_mtim.tv_sec * 1'000'000'000 + status.st_mtim.tv_nsec,
            static_cast<uint64_t>(status.st_size), static_cast<uint64_t>(status.st_ino)};
}

void FileWatch::watch(const std::set<std::filesystem::path>& files) {
    std::map<std::filesystem::path, Stamp> stamps;
    for (const auto& file : files) {
        const auto known = stamps_.find(file);
        stamps[file] = known != stamps_.end() ? known->second : stampOf(file);
    }
    stamps_ = std::move(stamps);
}

std::set<std::filesystem::path> FileWatch::changed() {
    std::set<std::filesystem::path> list;
    for (auto& [file, stamp] : stamps_) {
        const Stamp now = stampOf(file);
        if (now == stamp) continue;
        stamp = now;
        list.insert(file);
    }
    return list;
}

}  // namespace vitrine
