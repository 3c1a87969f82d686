// SPDX-License-Identifier: MIT
// Draws triangles that the vertex shader makes over a picture that is there already.
#pragma once

#include "gpu/image_pass.hpp"

namespace vitrine {

class OverlayRunner {
  public:
    OverlayRunner();
    ~OverlayRunner();
    OverlayRunner(const OverlayRunner&) = delete;
    OverlayRunner& operator=(const OverlayRunner&) = delete;

    /// Runs a raster program for `vertices` vertices, in order, and mixes its colour into the one
    /// output by its alpha; the picture stays as opaque as it was.
    void run(const Program& program, const UniformBlock& block, const PassImages& images,
             int vertices);

  private:
    unsigned framebuffer_ = 0, vertexArray_ = 0;
};

}  // namespace vitrine
