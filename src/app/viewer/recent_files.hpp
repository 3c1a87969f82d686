// SPDX-License-Identifier: MIT
// The files that were opened last, over all windows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {

class RecentFiles {
  public:
    static constexpr size_t kMost = 12;

    /// `list`: where they are kept, a path a line; "": nowhere.
    explicit RecentFiles(std::filesystem::path list);

    /// Puts a file first. A list that cannot be written lasts as long as this.
    void add(const std::string& file);
    /// Reads the list again, and which of its files are there.
    void refresh();
    /// Absolute paths of files that were there at the last refresh() or add(), the last one first.
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

  private:
    std::vector<std::string> read() const;
    std::filesystem::path list_;
    std::vector<std::string> files_;
};

/// The paths in the text of a list: absolute, of files that can be opened, each once, kMost at
/// most. Anything else in it is skipped.
std::vector<std::string> recentFilesOf(std::string_view text);

}  // namespace vitrine
