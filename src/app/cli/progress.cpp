// SPDX-License-Identifier: MIT
#include "app/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace vitrine {
namespace {

std::string duration(double seconds) {
    const int s = static_cast<int>(seconds + 0.5);
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{}:{:02} min", s / 60, s % 60);
    return fmt::format("{}:{:02} h", s / 3600, s / 60 % 60);
}

}  // namespace

Progress::Progress(int64_t total)
    : visible_(::isatty(STDERR_FILENO) == 1),
      total_(total),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    if (visible_ && done_ > 0) std::fputs("\r\033[K", stderr);
}

void Progress::step(const std::string& what) {
    ++done_;
    if (!visible_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - shown_ < std::chrono::milliseconds(100) && done_ < total_) return;
    shown_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double left = elapsed / static_cast<double>(done_) * static_cast<double>(total_ - done_);
    const std::string line =
        fmt::format("\r\033[K{}: {} of {}, {} left", what, done_, total_, duration(left));
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace vitrine
