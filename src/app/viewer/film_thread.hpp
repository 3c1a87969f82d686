// SPDX-License-Identifier: MIT
// Writes a film on a thread of its own, so that the window does not wait for the encoder.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "image/video.hpp"

namespace vitrine {

class FilmThread {
  public:
    enum class State { kWorking, kWritten, kFailed };

    /// Throws MachineError if ffmpeg is not installed or the folder cannot be written.
    FilmThread(const std::filesystem::path& file, int width, int height, double framesPerSecond);
    /// Leaves nothing behind of a film that is not written yet.
    ~FilmThread();
    FilmThread(const FilmThread&) = delete;
    FilmThread& operator=(const FilmThread&) = delete;

    /// Waits up to so long; whether the next picture can be taken. After a failure all are.
    [[nodiscard]] bool waitForRoom(std::chrono::milliseconds longest);
    /// Takes the film's next picture, of the film's size.
    void add(ImageRgba8 picture);
    /// There are no more pictures: the state will be another one soon.
    void close();
    /// Waits up to so long for that.
    void waitForEnd(std::chrono::milliseconds longest);
    [[nodiscard]] State state();
    /// Why it failed.
    [[nodiscard]] std::string problem();

  private:
    void run();
    VideoWriter writer_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<ImageRgba8> waiting_;
    State state_ = State::kWorking;
    std::string problem_;
    bool closed_ = false, abandoned_ = false;
    std::thread thread_;
};

}  // namespace vitrine
