// SPDX-License-Identifier: MIT
// Reading untrusted files and writing results that are whole or not there at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The bytes of a regular file (never a pipe, a device or a folder).
/// Throws InputError, placed at `path`, if it is missing, not regular, unreadable or over
/// `maxBytes`.
std::string readFile(const std::filesystem::path& path, uint64_t maxBytes);

/// What tells one state of a file from another without reading it.
struct FileStamp {
    int64_t nanoseconds = -1;  ///< of the last change; -1: there is no such file
    uint64_t size = 0, inode = 0;
    bool operator==(const FileStamp&) const = default;
};
FileStamp stampOf(const std::filesystem::path& path);
/// Files, and the state that each was in when it was read.
using FileStamps = std::map<std::filesystem::path, FileStamp>;

/// Notes the files that readFile() is asked for on this thread while it lives, missing ones as
/// well: what a scene depends on. Records may be nested; the inner one tells the outer one.
class ReadRecord {
  public:
    ReadRecord();
    ~ReadRecord();
    ReadRecord(const ReadRecord&) = delete;
    ReadRecord& operator=(const ReadRecord&) = delete;
    [[nodiscard]] const FileStamps& files() const { return files_; }
    /// As if these had been read now: for who remembers what is in them.
    static void note(const FileStamps& files);

  private:
    friend std::string readFile(const std::filesystem::path& path, uint64_t maxBytes);
    ReadRecord* outer_;
    FileStamps files_;
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
