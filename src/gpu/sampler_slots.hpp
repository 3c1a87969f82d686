// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/program.hpp"
#include "gpu/texture.hpp"

namespace vitrine {

/// What keeps Mesa's software drivers from compiling programs again and again. They do so whenever
/// they find samplers of another kind in a program's places than before, and in the place of a
/// texel buffer, which has none, they find what some other program has left there. Programs have
/// their buffers in the first places.
class SamplerSlots {
  public:
    /// The first places, that buffers may have.
    static constexpr int kOfBuffers = 6;

    SamplerSlots();
    ~SamplerSlots();
    SamplerSlots(const SamplerSlots&) = delete;
    SamplerSlots& operator=(const SamplerSlots&) = delete;

    /// Leaves the samplers of our images of floats in all places: when a context is made, and after
    /// programs that read other images in the first places.
    void fill();

  private:
    unsigned program_, framebuffer_ = 0, vertexArray_ = 0;
    Texture image_{1, 1, TexelFormat::kRgba8}, target_{1, 1, TexelFormat::kRgba8};
};

}  // namespace vitrine
