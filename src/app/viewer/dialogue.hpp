// SPDX-License-Identifier: MIT
// A box in the middle of the window that wants an answer before anything else goes on. There is one
// at a time: a new one sends the one before away.
#pragma once

#include <string>

#include "gpu/window.hpp"

namespace vitrine {

class Dialogue {
  public:
    /// `title` stands above it and tells it from others.
    Dialogue(Window& window, std::string title) : window_(window), title_(std::move(title)) {}

    void open();
    void close();
    [[nodiscard]] bool isOpen() const { return shown_ || wanted_; }

    /// Begins what is inside; if false it is not there, else end() must follow.
    [[nodiscard]] bool begin();
    void end();
    /// A button for yes, one that closes the box, and whether yes was said, by button or Enter.
    [[nodiscard]] bool answer(const char* yes);
    /// end() after an answer, which was good enough or has to be given again.
    void end(bool answered, bool good);

    /// An open one takes every key. Escape closes it.
    bool takeKey(const KeyPress& press);
    /// Whether Enter was pressed since the last call.
    [[nodiscard]] bool takeEnter();
    /// It has just been opened, or was not content with an answer: the frame in which to put the
    /// cursor into a field, which Enter has left.
    [[nodiscard]] bool isFresh() const { return freshFrames_ == kFreshFrames; }

  private:
    void askAgain();
    static constexpr int kFreshFrames = 12;
    Window& window_;
    std::string title_;
    bool wanted_ = false, shown_ = false, closing_ = false, enter_ = false;
    int freshFrames_ = 0;
};

/// A button that says what Enter does.
bool mainButton(const char* text);

}  // namespace vitrine
