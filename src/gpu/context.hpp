// SPDX-License-Identifier: MIT
// An OpenGL context without a window, and what the driver can do.
//
// EGL on the surfaceless platform (Mesa, with or without a GPU), then on every EGL device (drivers
// that have no surfaceless platform); GL 4.5 core, else 4.1 core without compute.
#pragma once

#include <memory>
#include <string>

namespace vitrine {

struct GpuInfo {
    std::string renderer, vendor, version;
    int glslVersion = 450;    ///< 450 or 410
    bool compute = true;      ///< compute shaders exist (GL 4.3)
    bool software = false;    ///< the "GPU" is this machine's CPU
    bool clipControl = true;  ///< reversed depth is possible (GL 4.5)
    int maxTextureBufferTexels = 0;
    int maxTextureSize = 0;
};

class Context {
  public:
    /// Makes a context and makes it current on this thread; when it goes, the one that was current
    /// before is so again. Throws MachineError, saying what to install, if there is no usable
    /// OpenGL.
    static std::unique_ptr<Context> createHeadless();
    virtual ~Context() = default;
    [[nodiscard]] const GpuInfo& info() const { return info_; }

  protected:
    Context() = default;
    /// Reads `info_` from the context that is current.
    void queryInfo();
    GpuInfo info_;
};

/// Waits until the GPU has done all it was told.
void finishGpu();

/// Throws MachineError naming `what` if GL reports an error (out of memory above all).
void checkGl(const char* what);

}  // namespace vitrine
