// SPDX-License-Identifier: MIT
#include "gpu/context.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "gpu/sampler_slots.hpp"

namespace vitrine {
namespace {

constexpr const char* kInstallHint =
    "no usable OpenGL: Vitrine needs EGL and OpenGL 4.1 or later; on Debian install "
    "'libegl1 libgl1-mesa-dri' (software rendering) or your GPU's driver";

class EglContext final : public Context {
  public:
    static std::unique_ptr<EglContext> create(EGLDisplay display) {
        const Current before;
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return nullptr;
        if (!eglBindAPI(EGL_OPENGL_API)) return nullptr;
        const std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglChooseConfig(display, wanted.data(), &config, 1, &count);
        if (count == 0) config = nullptr;  // EGL_KHR_no_config_context
        for (const EGLint minor : {5, 1}) {
            const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                                   4,
                                                   EGL_CONTEXT_MINOR_VERSION,
                                                   minor,
                                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                   EGL_NONE};
            EGLContext context =
                eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
            if (context == EGL_NO_CONTEXT) continue;
            if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
                eglDestroyContext(display, context);
                continue;
            }
            auto result = std::unique_ptr<EglContext>(new EglContext(display, context, before));
            result->queryInfo();
            return result;
        }
        return nullptr;
    }

    ~EglContext() override {
        // A later one may be in use; if not, the one before is again, if it still exists.
        if (eglGetCurrentContext() == context_ && !before_.makeCurrent())
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

  private:
    /// What is current when this is made.
    struct Current {
        EGLDisplay display = eglGetCurrentDisplay();
        EGLSurface draw = eglGetCurrentSurface(EGL_DRAW), read = eglGetCurrentSurface(EGL_READ);
        EGLContext context = eglGetCurrentContext();

        [[nodiscard]] bool makeCurrent() const {
            return context != EGL_NO_CONTEXT && eglMakeCurrent(display, draw, read, context);
        }
    };

    EglContext(EGLDisplay display, EGLContext context, const Current& before)
        : display_(display), context_(context), before_(before) {}
    EGLDisplay display_;
    EGLContext context_;
    Current before_;
};

bool hasExtension(const char* list, std::string_view name) {
    return list != nullptr && std::string_view(list).find(name) != std::string_view::npos;
}

/// Displays to try, best first.
std::vector<EGLDisplay> candidateDisplays() {
    std::vector<EGLDisplay> displays;
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!hasExtension(extensions, "EGL_EXT_platform_base")) return displays;
    const auto addDevices = [&] {
        if (!hasExtension(extensions, "EGL_EXT_platform_device") ||
            !hasExtension(extensions, "EGL_EXT_device_enumeration"))
            return;
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i)
            displays.push_back(
                eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    };
    // Mesa's surfaceless platform picks a GPU when it drives one. Where another vendor's driver
    // is installed beside Mesa, its devices come first or software would win over the GPU.
    const bool foreignDriver = ::access("/dev/nvidiactl", F_OK) == 0;
    if (foreignDriver) addDevices();
    if (hasExtension(extensions, "EGL_MESA_platform_surfaceless"))
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    if (!foreignDriver) addDevices();
    return displays;
}

std::string glText(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text != nullptr ? text : "";
}

}  // namespace

void Context::queryInfo() {
    info_.renderer = glText(GL_RENDERER);
    info_.vendor = glText(GL_VENDOR);
    info_.version = glText(GL_VERSION);
    const int version = epoxy_gl_version();
    info_.compute = version >= 43;
    info_.clipControl = version >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
    info_.glslVersion = version >= 45 ? 450 : 410;
    for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader"})
        if (info_.renderer.find(name) != std::string::npos) info_.software = true;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &info_.maxTextureBufferTexels);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info_.maxTextureSize);
    if (info_.software) SamplerSlots().fill();
}

std::unique_ptr<Context> Context::createHeadless() {
    for (EGLDisplay display : candidateDisplays())
        if (auto context = EglContext::create(display)) return context;
    throw MachineError(kInstallHint);
}

void finishGpu() {
    glFinish();
}

void checkGl(const char* what) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    throw MachineError(error == GL_OUT_OF_MEMORY
                           ? fmt::format("the GPU is out of memory ({})", what)
                           : fmt::format("OpenGL error 0x{:04x} ({})", error, what));
}

}  // namespace vitrine
