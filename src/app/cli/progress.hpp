// SPDX-License-Identifier: MIT
// A line of progress on a terminal, nothing in a pipe.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace vitrine {

class Progress {
  public:
    /// `total` steps of equal work.
    explicit Progress(int64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void step(const std::string& what);

  private:
    bool visible_;
    int64_t total_, done_ = 0;
    std::chrono::steady_clock::time_point start_, shown_;
};

}  // namespace vitrine
