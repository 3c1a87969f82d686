// SPDX-License-Identifier: MIT
#include "frame/pass_context.hpp"

#include <algorithm>
#include <utility>

namespace vitrine {

Texture PassContext::image(int width, int height, TexelFormat format) const {
    return imageStore_ == nullptr ? Texture(width, height, format)
                                  : imageStore_->take(width, height, format);
}

PathImages PassContext::pathImages(int width, int height) const {
    return {
        image(width, height, TexelFormat::kRgba32ui), image(width, height, TexelFormat::kRgba32f),
        image(width, height, TexelFormat::kRgba32f), image(width, height, TexelFormat::kRgba32f)};
}

/// After a program with images that are not of floats, or filtered, in the places of buffers.
void PassContext::restoreSamplers(const Program& program, const PassImages& images) {
    if (!compilesPerSampler_ || program.isCompute()) return;
    const auto early = [&program](const auto& input) {
        const int unit = program.unit(input.first);
        return unit >= 0 && unit < SamplerSlots::kOfBuffers;
    };
    const auto earlyInteger = [&](const auto& input) {
        return input.second->format() == TexelFormat::kRgba32ui && early(input);
    };
    if (std::none_of(images.inputs.begin(), images.inputs.end(), earlyInteger) &&
        std::none_of(images.arrays.begin(), images.arrays.end(), early) &&
        std::none_of(images.pictures.begin(), images.pictures.end(), early))
        return;
    if (!samplerSlots_) samplerSlots_.emplace();
    samplerSlots_->fill();
}

void PassContext::run(const std::string& pass, PassImages images) {
    const Program& program = programs.get(pass);
    images.buffers = scene.bindings();
    images.arrays = scene.arrays();
    images.pictures = scene.pictures();
    const bool counts = counting && findPass(pass).traces;
    if (counts) {
        images.inputs.emplace_back("countersBefore", &counters[0]);
        images.outputs.emplace_back("outCounters", &counters[1]);
    }
    uniforms_.upload(std::as_bytes(std::span(&block, 1)));
    if (timing) timer_.begin(pass);
    runner_.run(program, uniforms_, images, rows);
    restoreSamplers(program, images);
    if (timing) timer_.end();
    if (counts) std::swap(counters[0], counters[1]);
}

const RasterOrder& PassContext::rasterOrder(std::span<const PackedInstance> instances) {
    if (rasterOrder_.add(instances)) rasterRunner_.setIndices(rasterOrder_.indices());
    return rasterOrder_;
}

void PassContext::draw(const std::string& pass, const RasterImages& images,
                       std::span<const RasterDraw> draws) {
    const Program& program = programs.get(pass);
    RasterImages all = images;
    all.buffers = scene.bindings();
    all.arrays = scene.arrays();
    uniforms_.upload(std::as_bytes(std::span(&block, 1)));
    if (timing) timer_.begin(pass);
    rasterRunner_.run(program, uniforms_, all, VITRINE_RECORD_MISS, draws);
    restoreSamplers(program, {{}, {}, {}, all.arrays});
    if (timing) timer_.end();
    // The passes that follow add to what this one counted: nothing.
    if (counting) counters[0].clear();
}

void PassContext::drawBoxes(const std::string& pass, int onlyField, const RasterImages& images,
                            BoxTarget target, std::span<const BoxDraw> draws) {
    const Program& program = programs.get(pass, onlyField);
    RasterImages all = images;
    all.buffers = scene.bindings();
    all.arrays = scene.arrays();
    uniforms_.upload(std::as_bytes(std::span(&block, 1)));
    const bool timed = timing && target != BoxTarget::kSum;  // counting is no part of a frame
    if (timed) timer_.begin(pass);
    boxRunner_.run(program, uniforms_, all, target, VITRINE_RECORD_MISS, draws, rows);
    restoreSamplers(program, {{}, {}, {}, all.arrays});
    if (timed) timer_.end();
}

void PassContext::overlay(const std::string& pass, PassImages images, int vertices) {
    const Program& program = programs.get(pass);
    for (const auto& buffer : scene.bindings()) images.buffers.push_back(buffer);
    uniforms_.upload(std::as_bytes(std::span(&block, 1)));
    if (timing) timer_.begin(pass);
    overlayRunner_.run(program, uniforms_, images, vertices);
    restoreSamplers(program, images);
    if (timing) timer_.end();
}

}  // namespace vitrine
