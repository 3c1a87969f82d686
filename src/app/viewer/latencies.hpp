// SPDX-License-Identifier: MIT
// How long the window takes to answer, by what was asked of it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace vitrine {

class Latencies {
  public:
    /// A step of the window's loop is of the last kind, up to kReload, that took part in it.
    enum class Kind {
        kRefine,
        kPlay,
        kTurn,
        kPick,
        kEdit,
        kReload,
        kBehind,  ///< no step: reading and compiling, while the window shows what it has
    };

    /// From taking what has happened to showing the answer.
    void add(Kind kind, double seconds) { seconds_[static_cast<size_t>(kind)].push_back(seconds); }
    [[nodiscard]] bool empty() const;
    /// One line a kind: name, steps, and in milliseconds the median, the 95th of 100, the longest.
    [[nodiscard]] std::string table() const;

  private:
    std::array<std::vector<double>, 7> seconds_;
};

}  // namespace vitrine
