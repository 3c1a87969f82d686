// SPDX-License-Identifier: MIT
// Small pictures of scenes, drawn by our own renderer on a thread of the lowest priority, and kept
// for the next time.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/file.hpp"
#include "image/image.hpp"

namespace vitrine {

class Thumbnails {
  public:
    static constexpr int kWidth = 384, kHeight = 240;
    struct Result {
        size_t scene = 0;    ///< in the list of files
        ImageRgba8 picture;  ///< kWidth x kHeight; empty: the scene cannot be drawn
    };

    /// `cache`: the folder that keeps them, "": none. A picture there counts as long as `version`,
    /// the scene's text and the files that it was drawn from are the same.
    Thumbnails(std::vector<std::string> files, std::filesystem::path cache, std::string version);
    /// May wait for a scene that is being read.
    ~Thumbnails();
    Thumbnails(const Thumbnails&) = delete;
    Thumbnails& operator=(const Thumbnails&) = delete;

    /// The pictures that have come since the last call.
    std::vector<Result> take();
    /// Stops after the sample that is being drawn, or goes on.
    void setPaused(bool paused);

  private:
    void run();
    ImageRgba8 draw(const std::string& file, FileStamps& files);
    void deliver(size_t scene, ImageRgba8 picture);
    /// Waits while paused. Whether to give up.
    bool shouldStop();

    std::vector<std::string> files_;
    std::filesystem::path cache_;
    std::string version_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool stopped_ = false, paused_ = false;
    std::vector<Result> results_;
    std::thread thread_;
};

/// The name of a scene's picture in the cache: of its text and the program's version.
std::string thumbnailName(std::string_view text, std::string_view version);

/// What stands beside it, in a file of its name and ".files": what it was drawn from, a line each.
std::string thumbnailFiles(const FileStamps& files);
/// Whether all of them are as they were.
bool areUnchanged(std::string_view thumbnailFiles);

}  // namespace vitrine
