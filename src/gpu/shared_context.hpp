// SPDX-License-Identifier: MIT
// A context beside the window's, for work on another thread. It shares textures, buffers and
// programs with the window's; framebuffers, vertex arrays and what a software driver compiles are
// its own, so what is made in it is used in it, and that on one thread at a time.
#pragma once

#include "gpu/context.hpp"

struct GLFWwindow;

namespace vitrine {

class SharedContext final : public Context {
  public:
    /// Of a window without a surface that anybody sees, which goes with it. Made by
    /// Window::makeContext().
    explicit SharedContext(GLFWwindow* hidden);
    /// On the window's thread, current nowhere.
    ~SharedContext() override;
    SharedContext(const SharedContext&) = delete;
    SharedContext& operator=(const SharedContext&) = delete;

  private:
    friend class ContextUse;
    GLFWwindow* hidden_;
};

/// While it lives the context is current on this thread; then what was current before is again, or
/// none. Uses may be nested. What was drawn is finished by then, for other contexts to see.
class ContextUse {
  public:
    explicit ContextUse(const SharedContext& context);
    ~ContextUse();
    ContextUse(const ContextUse&) = delete;
    ContextUse& operator=(const ContextUse&) = delete;

  private:
    GLFWwindow* before_;
};

}  // namespace vitrine
