// SPDX-License-Identifier: MIT
// Runs a program once for every pixel: images and buffers in, images out. The same call draws a
// full-screen triangle or dispatches compute groups, as the program was built.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gpu/bindings.hpp"

namespace vitrine {

struct PassImages {
    Named<Texture> inputs;
    Named<TexelBuffer> buffers;
    /// All of one size; that size is what is drawn.
    Named<Texture> outputs;
    Named<TextureArray> arrays = {};
    Named<MipTexture> pictures = {};
};

/// Rows of an image from the bottom, `end` not included; to the top if there are fewer.
struct PixelRows {
    int begin = 0, end = 1 << 30;
};

class PassRunner {
  public:
    PassRunner();
    ~PassRunner();
    PassRunner(const PassRunner&) = delete;
    PassRunner& operator=(const PassRunner&) = delete;

    /// Names the program does not use are ignored: a variant may need less. Of the outputs only
    /// `rows` are drawn; a compute program draws all of them always.
    void run(const Program& program, const UniformBlock& block, const PassImages& images,
             PixelRows rows = {});

  private:
    void draw(const Program& program, const PassImages& images, PixelRows rows);
    void dispatch(const Program& program, const PassImages& images);
    unsigned framebuffer_ = 0, vertexArray_ = 0;
};

}  // namespace vitrine
