// SPDX-License-Identifier: MIT
// Films: pictures piped to the program `ffmpeg`.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "image/image.hpp"

namespace vitrine {

/// Whether a file's name says that it is a film: .mp4 (H.264), .webm (VP9) or .gif.
bool isVideoName(const std::filesystem::path& file);

/// Writes one film. The file appears under its name when it is whole, and never before: until then
/// it lies beside it, and is removed if anything fails or finish() is not called.
class VideoWriter {
  public:
    /// Throws MachineError if ffmpeg is not installed or the folder cannot be written.
    VideoWriter(std::filesystem::path file, int width, int height, double framesPerSecond);
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Precondition: the picture has the film's size. Throws MachineError with what ffmpeg said.
    void add(const ImageRgba8& picture);
    /// Waits for ffmpeg and puts the film in its place. Throws MachineError.
    void finish();

  private:
    void start(double framesPerSecond);
    [[noreturn]] void fail();
    void abandon();
    [[nodiscard]] std::string complaint();

    std::filesystem::path file_, unfinished_, log_;
    int width_, height_;
    int pipe_ = -1;
    pid_t process_ = -1;
};

}  // namespace vitrine
