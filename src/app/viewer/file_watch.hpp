// SPDX-License-Identifier: MIT
// Notices that files change: by asking, which works on every file system and for every way in which
// editors write (in place, or a new file renamed over the old one).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>

namespace vitrine {

class FileWatch {
  public:
    /// The files to look at from now on; those known already keep their state.
    void watch(const std::set<std::filesystem::path>& files);
    /// The files that are not as they were at the last call (or at watch()).
    std::set<std::filesystem::path> changed();

  private:
    struct Stamp {
        int64_t nanoseconds = -1;
        uint64_t size = 0, inode = 0;
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stampOf(const std::filesystem::path& file);
    std::map<std::filesystem::path, Stamp> stamps_;
};

}  // namespace vitrine
