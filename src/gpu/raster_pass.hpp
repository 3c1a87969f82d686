// SPDX-License-Identifier: MIT
// Draws triangles that the vertex shader fetches itself, with a depth buffer: for the finders of
// first hits that use the rasteriser.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/math.hpp"
#include "gpu/bindings.hpp"

namespace vitrine {

/// Of the indices, in which a triangle has three.
struct RasterRange {
    uint32_t first = 0, count = 0;
};

/// Triangles of one instance of a mesh; the members become uniforms of pass/raster.glsl.
struct RasterDraw {
    glm::mat4 clipFromObject{1};
    int instance = 0;
    int firstTriangle = 0;
    std::vector<RasterRange> ranges;
    bool culled = false;    ///< triangles seen from behind are not drawn
    bool mirrored = false;  ///< the matrix turns left into right, and fronts into backs
};

struct RasterImages {
    Named<TexelBuffer> buffers;
    std::pair<std::string, const Texture*> output;
    Named<TextureArray> arrays;
    const DepthImage* depth = nullptr;
};

class RasterRunner {
  public:
    RasterRunner();
    ~RasterRunner();
    RasterRunner(const RasterRunner&) = delete;
    RasterRunner& operator=(const RasterRunner&) = delete;

    /// Of the corners, triangle by triangle; a mesh counts its own from 0. Ranges refer to this.
    void setIndices(std::span<const uint32_t> indices);

    /// Clears depth to infinity and the RGBA32UI output to `clearTo` in all channels, then draws.
    /// Depth is reversed: 1 at the near plane, 0 at infinity (Reed, Depth Precision Visualized,
    /// 2015), so that floats are as precise far away as they are near.
    void run(const Program& program, const UniformBlock& block, const RasterImages& images,
             uint32_t clearTo, std::span<const RasterDraw> draws);

  private:
    unsigned framebuffer_ = 0, vertexArray_ = 0, indices_ = 0;
};

}  // namespace vitrine
