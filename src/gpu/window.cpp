// SPDX-License-Identifier: MIT
#include "gpu/window.hpp"

#include <epoxy/gl.h>
// After epoxy, which stands for the system's own OpenGL header.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gpu/interface_look.hpp"

namespace vitrine {
namespace {

static_assert(kKeyEscape == GLFW_KEY_ESCAPE && kKeyEnter == GLFW_KEY_ENTER &&
              kKeyKeypadEnter == GLFW_KEY_KP_ENTER && kKeyTab == GLFW_KEY_TAB &&
              kKeyRight == GLFW_KEY_RIGHT && kKeyLeft == GLFW_KEY_LEFT &&
              kKeyHome == GLFW_KEY_HOME && kKeyF11 == GLFW_KEY_F11 && kKeyF12 == GLFW_KEY_F12 &&
              GLFW_KEY_A == 'A' && GLFW_KEY_0 == '0' && GLFW_KEY_SPACE == ' ');

std::string& lastGlfwError() {
    static std::string text;
    return text;
}

/// A context that belongs to a window and goes with it.
class WindowContext final : public Context {
  public:
    WindowContext() { queryInfo(); }
};

/// With `shared`, nobody sees it: it is there for its context.
GLFWwindow* createWindow(int width, int height, const std::string& title,
                         GLFWwindow* shared = nullptr) {
    glfwWindowHint(GLFW_VISIBLE, shared == nullptr ? GLFW_TRUE : GLFW_FALSE);
    for (const int minor : {5, 1}) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        if (GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, shared))
            return window;
    }
    return nullptr;
}

}  // namespace

std::unique_ptr<Window> Window::open(int width, int height, const std::string& title) {
    glfwSetErrorCallback([](int, const char* text) { lastGlfwError() = text; });
    if (glfwInit() == GLFW_FALSE)
        throw NoDisplay(fmt::format("there is no display for a window ({})", lastGlfwError()));
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        PixelRectangle free;
        glfwGetMonitorWorkarea(monitor, &free.x, &free.y, &free.width, &free.height);
        if (free.width > 0 && free.height > 0) {
            width = std::min(width, free.width);
            height = std::min(height, free.height);
        }
    }
    std::unique_ptr<Window> result(new Window);
    result->window_ = createWindow(width, height, title);
    if (result->window_ == nullptr)
        throw MachineError(
            fmt::format("the display has no OpenGL 4.1 ({}); on Debian install "
                        "'libgl1-mesa-dri' (software rendering) or your GPU's driver",
                        lastGlfwError()));
    glfwMakeContextCurrent(result->window_);
    glfwSwapInterval(1);
    result->context_ = std::make_unique<WindowContext>();
    glGenFramebuffers(1, &result->framebuffer_);

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // nothing is written behind the user's back
    ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
    result->installCallbacks();
    ImGui_ImplGlfw_InitForOpenGL(result->window_, true);
    ImGui_ImplOpenGL3_Init("#version 410 core");
    result->chooseScale();
    result->measure();
    return result;
}

Window::~Window() {
    if (context_ != nullptr) {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        glDeleteFramebuffers(1, &framebuffer_);
    }
    if (window_ != nullptr) glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::installCallbacks() {
    glfwSetWindowUserPointer(window_, this);
    // ImGui's own callbacks, installed afterwards, call these too.
    const auto touch = [](GLFWwindow* w) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->hadEvents_ = true;
    };
    static const auto event = touch;
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { event(w); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { event(w); });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { event(w); });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
        if (action == GLFW_PRESS)
            static_cast<Window*>(glfwGetWindowUserPointer(w))
                ->pressed_.push_back(
                    {key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0});
        event(w);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { event(w); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { event(w); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { event(w); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { event(w); });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { event(w); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { event(w); });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** files) {
        auto* self = static_cast<Window*>(glfwGetWindowUserPointer(w));
        self->dropped_.insert(self->dropped_.end(), files, files + count);
        event(w);
    });
}

void Window::chooseScale() {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    scale_ = std::clamp(x, 1.0f, 4.0f);
    chooseInterfaceLook(scale_);
}

void Window::measure() {
    glfwGetFramebufferSize(window_, &width_, &height_);
}

bool Window::takeCloseRequest() {
    const bool asked = glfwWindowShouldClose(window_) == GLFW_TRUE;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return asked;
}

void Window::hide() {
    glfwHideWindow(window_);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

bool Window::isFullScreen() const {
    return glfwGetWindowMonitor(window_) != nullptr;
}

void Window::setFullScreen(bool full) {
    if (full == isFullScreen()) return;
    if (!full) {
        glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width,
                             windowed_.height, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) return;
    glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
    glfwGetWindowSize(window_, &windowed_.width, &windowed_.height);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::begin(double seconds) {
    hadEvents_ = std::exchange(woken_, false);
    if (seconds > 0 && !hadEvents_)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    measure();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::end() {
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width_, height_);
    // ImGui goes back to the program that it finds, which may be deleted and live only until then.
    glUseProgram(0);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
    checkGl("showing the window");
}

void Window::skip() {
    ImGui::EndFrame();
}

void Window::clear() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width_, height_);
    glClearColor(0.055f, 0.058f, 0.065f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Window::show(const Texture& picture, PixelRectangle part, PixelRectangle clip) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.id(),
                           0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(clip.x, clip.y, clip.width, clip.height);
    const bool same = part.width == picture.width() && part.height == picture.height();
    glBlitFramebuffer(0, 0, picture.width(), picture.height(), part.x, part.y, part.x + part.width,
                      part.y + part.height, GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
    glDisable(GL_SCISSOR_TEST);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<KeyPress> Window::takeKeyPresses() {
    return std::exchange(pressed_, {});
}

std::unique_ptr<SharedContext> Window::makeContext() {
    GLFWwindow* hidden = createWindow(1, 1, "", window_);
    if (hidden == nullptr)
        throw MachineError(
            fmt::format("the driver gives no second OpenGL context ({})", lastGlfwError()));
    return std::make_unique<SharedContext>(hidden);
}

void Window::ring() {
    glfwPostEmptyEvent();
}

std::vector<std::string> Window::takeDroppedFiles() {
    return std::exchange(dropped_, {});
}

}  // namespace vitrine
