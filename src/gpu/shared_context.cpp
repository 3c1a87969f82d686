// SPDX-License-Identifier: MIT
#include "gpu/shared_context.hpp"

#include <GLFW/glfw3.h>

namespace vitrine {

SharedContext::SharedContext(GLFWwindow* hidden) : hidden_(hidden) {
    const ContextUse use(*this);
    queryInfo();
}

SharedContext::~SharedContext() {
    glfwDestroyWindow(hidden_);
}

ContextUse::ContextUse(const SharedContext& context) : before_(glfwGetCurrentContext()) {
    if (before_ != context.hidden_) glfwMakeContextCurrent(context.hidden_);
}

ContextUse::~ContextUse() {
    finishGpu();
    if (glfwGetCurrentContext() != before_) glfwMakeContextCurrent(before_);
}

}  // namespace vitrine
