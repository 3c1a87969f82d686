// SPDX-License-Identifier: MIT
// Draws boxes whose pixels a fragment shader then looks into, with a depth buffer that it writes:
// for the finder of first hits that marches through distance fields.
#pragma once

#include <span>

#include "gpu/image_pass.hpp"
#include "gpu/raster_pass.hpp"

namespace vitrine {

/// One box; the members become uniforms of entry/march.vert.glsl.
struct BoxDraw {
    glm::mat4 clipFromBox{1};  ///< of the cube from -1 to 1, outside out
    int instance = 0;
};

enum class BoxTarget {
    kNearest,         ///< an output that stands already: what is nearer replaces it
    kNearestCleared,  ///< an RGBA32UI output and depth that are cleared first, as RasterRunner does
    kSum,             ///< an RGBA32F output: red, green and blue of all boxes of a pixel are added
                      ///< to it, of alpha the most counts; there is no depth
};

class BoxRunner {
  public:
    BoxRunner();
    ~BoxRunner();
    BoxRunner(const BoxRunner&) = delete;
    BoxRunner& operator=(const BoxRunner&) = delete;

    /// Draws the insides of the boxes, so that the eye may stand in them. `clearTo`: of
    /// kNearestCleared. Clears and draws `rows` only.
    void run(const Program& program, const UniformBlock& block, const RasterImages& images,
             BoxTarget target, uint32_t clearTo, std::span<const BoxDraw> draws,
             PixelRows rows = {});

  private:
    unsigned framebuffer_ = 0, vertexArray_ = 0;
};

}  // namespace vitrine
