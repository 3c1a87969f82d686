// SPDX-License-Identifier: MIT
// Notices that files change: by asking, which works on every file system and for every way in which
// editors write (in place, or a new file renamed over the old one).
#pragma once

#include <filesystem>
#include <set>
#include <utility>

#include "base/file.hpp"

namespace vitrine {

class FileWatch {
  public:
    /// The files to look at from now on, and the states that are known of them.
    void watch(FileStamps files) { stamps_ = std::move(files); }
    /// The files that are not as they were at the last call (or as watch() has been told).
    std::set<std::filesystem::path> changed();

  private:
    FileStamps stamps_;
};

}  // namespace vitrine
