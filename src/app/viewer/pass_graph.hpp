// SPDX-License-Identifier: MIT
// A graph of the milliseconds that each pass took, sample by sample, newest to the right.
#pragma once

#include <deque>
#include <map>
#include <string>

#include "base/math.hpp"

namespace vitrine {

using PassSeconds = std::map<std::string, double>;

/// What was added to sums between two looks at them.
PassSeconds difference(const PassSeconds& sums, const PassSeconds& before);

class PassGraph {
  public:
    static constexpr size_t kMostSamples = 100;

    void add(PassSeconds sample);
    [[nodiscard]] const std::deque<PassSeconds>& samples() const { return samples_; }
    /// Over the upper left of the picture: a stack a sample, and the newest one in numbers.
    void draw() const;

  private:
    std::deque<PassSeconds> samples_;
};

}  // namespace vitrine
