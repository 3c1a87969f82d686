// SPDX-License-Identifier: MIT
// A window with an OpenGL context and an immediate-mode interface (Dear ImGui) on top of a picture.
// What is input reaches the program through ImGui's state, but for single key presses.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/context.hpp"
#include "gpu/no_display.hpp"
#include "gpu/shared_context.hpp"
#include "gpu/texture.hpp"

struct GLFWwindow;

namespace vitrine {

/// A part of the window in pixels, from the lower left.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The keys that have no character; letters, digits and space are their capital characters.
enum SpecialKey : int {
    kKeyEscape = 256,
    kKeyEnter = 257,
    kKeyTab = 258,
    kKeyRight = 262,
    kKeyLeft = 263,
    kKeyHome = 268,
    kKeyF11 = 300,
    kKeyF12 = 301,
    kKeyKeypadEnter = 335,
};

/// A key that went down: a character or a SpecialKey, also for ImGui::IsKeyDown().
struct KeyPress {
    int key = 0;
    bool control = false, shift = false;
};

class Window {
  public:
    /// Not larger than the screen. GL 4.5 core, else 4.1. Throws NoDisplay, or MachineError if the
    /// display has no usable OpenGL.
    static std::unique_ptr<Window> open(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] const Context& context() const { return *context_; }
    /// Whether the desktop asked to close the window since the last call.
    bool takeCloseRequest();
    /// Out of sight, for what has to be done before it goes.
    void hide();
    void setTitle(const std::string& title);
    void setFullScreen(bool full);
    [[nodiscard]] bool isFullScreen() const;

    /// Pixels of the window's inside, and pixels an ImGui unit.
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] float scale() const { return scale_; }

    /// Takes what has happened and begins a frame of the interface. Waits up to `seconds` for
    /// something to happen; 0 does not wait.
    void begin(double seconds);
    /// Whether anything came in with the last begin(): then the interface must be drawn.
    [[nodiscard]] bool hadEvents() const { return hadEvents_; }
    /// The next begin() does as if something had happened.
    void wake() { woken_ = true; }
    /// Draws the interface, shows everything, ends the frame.
    void end();
    /// Ends the frame without drawing: the window stays as it is.
    void skip();
    /// Clears the window, then fills `part` with the texture, whatever its size; only what of it
    /// is inside of `clip`.
    void clear();
    void show(const Texture& picture, PixelRectangle part, PixelRectangle clip);
    void show(const Texture& picture, PixelRectangle part) { show(picture, part, part); }

    /// The keys pressed since the last call. ImGui forgets those that are up again when a frame
    /// begins, which may be late on a slow machine.
    std::vector<KeyPress> takeKeyPresses();
    /// A context that shares the window's textures, buffers and programs. It must go before the
    /// window. Throws MachineError if the driver has none to give.
    [[nodiscard]] std::unique_ptr<SharedContext> makeContext();
    /// From any thread: ends a wait in begin().
    static void ring();

    /// The files dropped on the window since the last call.
    std::vector<std::string> takeDroppedFiles();

  private:
    Window() = default;
    void installCallbacks();
    void chooseScale();
    void measure();

    GLFWwindow* window_ = nullptr;
    std::unique_ptr<Context> context_;
    unsigned framebuffer_ = 0;
    int width_ = 0, height_ = 0;
    float scale_ = 1;
    bool hadEvents_ = true, woken_ = true;
    PixelRectangle windowed_;
    std::vector<KeyPress> pressed_;
    std::vector<std::string> dropped_;
};

}  // namespace vitrine
