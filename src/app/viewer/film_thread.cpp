// SPDX-License-Identifier: MIT
#include "app/viewer/film_thread.hpp"

#include <exception>
#include <utility>

namespace vitrine {
namespace {

// One being encoded and one waiting: the encoder never stands still, and memory stays small.
constexpr size_t kMostWaiting = 2;

}  // namespace

FilmThread::FilmThread(const std::filesystem::path& file, int width, int height,
                       double framesPerSecond)
    : writer_(file, width, height, framesPerSecond), thread_([this] { run(); }) {}

FilmThread::~FilmThread() {
    {
        const std::lock_guard lock(mutex_);
        abandoned_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

bool FilmThread::waitForRoom(std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, longest, [this] {
        return waiting_.size() < kMostWaiting || state_ != State::kWorking;
    });
}

void FilmThread::add(ImageRgba8 picture) {
    {
        const std::lock_guard lock(mutex_);
        if (state_ == State::kWorking) waiting_.push_back(std::move(picture));
    }
    changed_.notify_all();
}

void FilmThread::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

void FilmThread::waitForEnd(std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [this] { return state_ != State::kWorking; });
}

FilmThread::State FilmThread::state() {
    const std::lock_guard lock(mutex_);
    return state_;
}

std::string FilmThread::problem() {
    const std::lock_guard lock(mutex_);
    return problem_;
}

void FilmThread::run() {
    State end = State::kWritten;
    std::string problem;
    try {
        std::unique_lock lock(mutex_);
        while (true) {
            changed_.wait(lock, [this] { return abandoned_ || closed_ || !waiting_.empty(); });
            if (abandoned_) return;
            if (waiting_.empty()) break;
            const ImageRgba8 picture = std::move(waiting_.front());
            waiting_.pop_front();
            lock.unlock();
            changed_.notify_all();
            writer_.add(picture);
            lock.lock();
        }
        lock.unlock();
        writer_.finish();
    } catch (const std::exception& error) {
        end = State::kFailed;
        problem = error.what();
    }
    {
        const std::lock_guard lock(mutex_);
        state_ = end;
        problem_ = std::move(problem);
        waiting_.clear();
    }
    changed_.notify_all();
}

}  // namespace vitrine
