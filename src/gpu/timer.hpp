// SPDX-License-Identifier: MIT
// Seconds by pass. GPU timer queries on a GPU; on a software driver, where queries see neither the
// worker threads nor lazy compilation, wall time between two finished states.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace vitrine {

class PassTimer {
  public:
    explicit PassTimer(bool softwareDriver) : wall_(softwareDriver) {}
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    void begin(const std::string& pass);
    void end();
    /// Seconds by pass since the last call of reset(). Waits for the GPU.
    [[nodiscard]] const std::map<std::string, double>& seconds();
    void reset();

  private:
    struct Pending {
        std::string pass;
        unsigned query;
    };
    bool wall_;
    std::string current_;
    std::chrono::steady_clock::time_point start_;
    std::vector<Pending> pending_;
    std::map<std::string, double> seconds_;
};

}  // namespace vitrine
