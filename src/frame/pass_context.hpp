// SPDX-License-Identifier: MIT
// What every pass needs to run, and the bookkeeping around a run: uniforms, time, counters.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "frame/gpu_scene.hpp"
#include "frame/programs.hpp"
#include "frame/raster_order.hpp"
#include "gpu/box_pass.hpp"
#include "gpu/image_store.hpp"
#include "gpu/overlay_pass.hpp"
#include "gpu/raster_pass.hpp"
#include "gpu/sampler_slots.hpp"
#include "gpu/timer.hpp"

namespace vitrine {

/// One step of every path: what was hit, and the ray that hit it. The camera's rays are not stored.
struct PathImages {
    Texture records, origin, direction, throughput;
};

class PassContext {
  public:
    PassContext(const GpuInfo& gpu, ProgramSet set, bool count,
                std::shared_ptr<ImageStore> imageStore = nullptr)
        : programs(std::move(set)),
          counting(count),
          compilesPerSampler_(gpu.software),
          imageStore_(std::move(imageStore)),
          timer_(gpu.software) {}

    /// An image for passes to write to. What is in it is not known.
    [[nodiscard]] Texture image(int width, int height, TexelFormat format) const;
    [[nodiscard]] PathImages pathImages(int width, int height) const;

    /// Runs the pass of this name over the pixels of `rows`. The scene's buffers are always there
    /// for it.
    void run(const std::string& pass, PassImages images);

    /// Draws triangles into the records.
    void draw(const std::string& pass, const RasterImages& images,
              std::span<const RasterDraw> draws);

    /// Draws boxes of fields into the records, or into what counts what that costs.
    void drawBoxes(const std::string& pass, int onlyField, const RasterImages& images,
                   BoxTarget target, std::span<const BoxDraw> draws);

    /// The order in which draw() takes triangles, with the meshes of these instances in it.
    const RasterOrder& rasterOrder(std::span<const PackedInstance> instances);

    /// Draws `vertices` corners of triangles over a picture, mixed by their alpha.
    void overlay(const std::string& pass, PassImages images, int vertices);

    FrameBlock block{};
    PixelRows rows;  ///< what run() draws
    GpuScene scene;
    ProgramSet programs;
    const bool counting;              ///< passes that trace keep counts
    std::array<Texture, 2> counters;  ///< of this sample; [0] is the latest
    PassTimer& timer() { return timer_; }
    bool timing = false;

  private:
    void restoreSamplers(const Program& program, const PassImages& images);
    const bool compilesPerSampler_;
    std::shared_ptr<ImageStore> imageStore_;  ///< or nullptr
    std::optional<SamplerSlots> samplerSlots_;
    PassRunner runner_;
    RasterRunner rasterRunner_;
    BoxRunner boxRunner_;
    RasterOrder rasterOrder_;
    OverlayRunner overlayRunner_;
    UniformBlock uniforms_;
    PassTimer timer_;
};

}  // namespace vitrine
