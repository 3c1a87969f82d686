// SPDX-License-Identifier: MIT
// What the window has to say: a passing message, why a file was refused, what is wrong with the
// scene's files.
#pragma once

#include <chrono>
#include <string>

#include "base/error.hpp"
#include "base/math.hpp"
#include "gpu/window.hpp"

namespace vitrine {

class Notices {
  public:
    explicit Notices(Window& window) : window_(window) {}

    /// A sentence that goes by itself.
    void say(std::string text);
    /// Why something that was asked for is not done. Goes by itself, later.
    void refuse(Diagnostics why);
    void forgetRefusal() { refusal_ = {}; }

    /// `problems`: of the scene's files as they are now. They stand until they are mended.
    void draw(const Diagnostics& problems, glm::vec2 pictureSize);

  private:
    using Clock = std::chrono::steady_clock;
    Window& window_;
    std::string message_;
    Diagnostics refusal_;
    Clock::time_point messageAt_{}, refusedAt_{};
};

}  // namespace vitrine
