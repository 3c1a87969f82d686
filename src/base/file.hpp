// SPDX-License-Identifier: MIT
// Reading untrusted files and writing results that are whole or not there at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The bytes of a regular file (never a pipe, a device or a folder).
/// Throws InputError, placed at `path`, if it is missing, not regular, unreadable or over
/// `maxBytes`.
std::string readFile(const std::filesystem::path& path, uint64_t maxBytes);

/// Notes the files that readFile() is asked for on this thread while it lives, missing ones as
/// well: what a scene depends on. Records may be nested; the inner one tells the outer one.
class ReadRecord {
  public:
    ReadRecord();
    ~ReadRecord();
    ReadRecord(const ReadRecord&) = delete;
    ReadRecord& operator=(const ReadRecord&) = delete;
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }

  private:
    friend std::string readFile(const std::filesystem::path& path, uint64_t maxBytes);
    ReadRecord* outer_;
    std::set<std::filesystem::path> files_;
};

/// Where `reference`, written in a file of the folder `root`, points. Throws std::invalid_argument
/// with a sentence for the user if it is absolute or leads out of `root`, by ".." or by a link.
/// The file need not exist.
std::filesystem::path resolveInside(const std::filesystem::path& root, std::string_view reference);

/// Writes beside `path`, syncs, then renames: a reader sees the old file or all of the new one.
/// Throws MachineError if anything fails, and leaves no partial file.
void writeFileAtomically(const std::filesystem::path& path, std::span<const uint8_t> bytes);
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);

/// Throws MachineError if a file could not be created at `path`. For asking before hours of work.
void checkWritable(const std::filesystem::path& path);

}  // namespace vitrine
