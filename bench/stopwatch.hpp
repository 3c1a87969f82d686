// SPDX-License-Identifier: MIT
// Time that can be compared on a busy machine.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

namespace vitrine {

/// On a software driver the time of the processor, over all threads; on a GPU wall time.
class Stopwatch {
  public:
    explicit Stopwatch(bool software) : software_(software) {}
    double secondsOf(const std::function<void()>& work) const {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t cpuStart = std::clock();
        work();
        const std::clock_t cpuEnd = std::clock();
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
        return software_ ? double(cpuEnd - cpuStart) / CLOCKS_PER_SEC : wall.count();
    }

  private:
    bool software_;
};

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace vitrine
