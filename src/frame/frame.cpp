// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "pack/camera.hpp"

namespace vitrine {

Frame::Frame(const Context& context, const PackedScene& scene, Backend backend, bool counters)
    : context_(context.info(),
               ProgramSet(context.info(), backend, scene.shaders,
                          {scene.hasMeshes, scene.hasFields, counters, scene.textures.any(),
                           scene.hasVertexExtras, scene.hasTangents}),
               counters),
      rasterPossible_(context.info().clipControl),
      maxSide_(context.info().maxTextureSize) {
    update(scene);
}

void Frame::update(const PackedScene& scene) {
    context_.scene.upload(scene);
    context_.block = scene.block;
    instances_ = scene.instances;
    fieldRoot_ = scene.fieldRoot;
}

void Frame::begin(const FrameRequest& request) {
    const bool resized = request.width != request_.width || request.height != request_.height ||
                         request.ssaa != request_.ssaa || !picture_.valid();
    request_ = request;
    sample_ = 0;
    statistics_ = {};
    context_.timer().reset();
    context_.timing = context_.counting;

    FrameBlock& block = context_.block;
    const int width = request.width * request.ssaa, height = request.height * request.ssaa;
    if (std::max(width, height) > maxSide_)
        throw MachineError(
            fmt::format("{}x{} pixels are drawn with render.ssaa = {}; this driver "
                        "allows {} a side",
                        width, height, request.ssaa, maxSide_));
    packCamera(request.camera, width, height, block);
    block.shading.x = request.time;
    block.image.w = static_cast<int>(request.view);
    block.sampling.y = request.samples;
    block.sampling.w = request.seed;
    // Enough rays for ambient occlusion that a picture of few samples is not speckled.
    block.display.w = static_cast<float>(std::clamp(16 / request.samples, 1, 16));
    if (!resized) return;
    const auto image = [&](TexelFormat f) { return Texture(width, height, f); };
    for (PathImages& path : paths_) path.allocate(width, height);
    for (Texture& t : radiance_) t = image(TexelFormat::kRgba32f);
    for (Texture& t : mean_) t = image(TexelFormat::kRgba32f);
    for (Texture& t : context_.counters) t = image(TexelFormat::kRgba32ui);
    picture_ = Texture(request.width, request.height, TexelFormat::kRgba8);
    depth_ = DepthImage(width, height);
    black_ = image(TexelFormat::kRgba32f);
    black_.clear();
}

void Frame::drawSample() {
    context_.block.sampling.x = sample_;
    const glm::vec2 jitter = sampleOffset(sample_, request_.samples);
    context_.block.jitter = glm::vec4(jitter, request_.ssaa, 0);
    findFirstHits();
    if (!showsRecords(request_.view)) followPaths();
    if (showsRecords(request_.view) || showsCounters(request_.view)) {
        // The records of the camera rays are gone after the bounces; counters need no records.
        viewPass(context_, paths_[0].records, radiance_[0]);
    }
    accumulatePass(context_, radiance_[0], mean_[0], mean_[1]);
    std::swap(mean_[0], mean_[1]);
    if (context_.counting) addCounts();
    ++sample_;
}

void Frame::findFirstHits() {
    if (request_.primary == Primary::kTrace || !rasterPossible_) {
        visibilityPass(context_, paths_[0].records);
        return;
    }
    const glm::mat4 clipFromWorld = packProjection(context_.block);
    std::vector<RasterDraw> draws;
    for (size_t i = 0; i < instances_.size(); ++i)
        if (!instances_[i].field)
            draws.push_back({clipFromWorld * instances_[i].worldFromObject, static_cast<int>(i),
                             instances_[i].firstTriangle,
                             static_cast<int>(instances_[i].triangles)});
    const bool fields = fieldRoot_ >= 0;
    rasterPass(context_, draws, depth_, paths_[fields ? 1 : 0].records);
    if (fields) visibilityFieldsPass(context_, fieldRoot_, paths_[1].records, paths_[0].records);
}

/// Light at the first hits, then bounce by bounce. Leaves the result in radiance_[0].
void Frame::followPaths() {
    const bool firstHitOnly = request_.view == View::kDirect || request_.view == View::kShadow;
    const bool reflectionOnly = request_.view == View::kReflection;
    if (reflectionOnly)
        radiance_[0].clear();
    else
        lightPass(context_, paths_[0], black_, radiance_[0]);
    for (int bounce = 0; bounce < request_.bounces && !firstHitOnly; ++bounce) {
        bouncePass(context_, paths_[0], paths_[1]);
        lightPass(context_, paths_[1], radiance_[0], radiance_[1]);
        std::swap(paths_[0], paths_[1]);
        std::swap(radiance_[0], radiance_[1]);
    }
}

ImageRgba8 Frame::picture() {
    const glm::ivec4 drawn = context_.block.image;
    context_.block.image.x = request_.width;
    context_.block.image.y = request_.height;
    displayPass(context_, mean_[0], picture_);
    context_.block.image = drawn;
    const std::vector<uint8_t> bytes = picture_.readBytes();
    ImageRgba8 image(request_.width, request_.height);
    const size_t row = static_cast<size_t>(request_.width) * 4;
    for (int y = 0; y < request_.height; ++y) {
        const auto* source = bytes.data() + static_cast<size_t>(request_.height - 1 - y) * row;
        std::copy(source, source + row, image.pixels.data() + static_cast<size_t>(y) * row);
    }
    return image;
}

void Frame::addCounts() {
    const std::vector<uint32_t> texels = context_.counters[0].readUints();
    statistics_.primaryRays += texels.size() / 4;
    for (size_t i = 0; i < texels.size(); i += 4) {
        statistics_.largestLoopCount = std::max(statistics_.largestLoopCount, texels[i]);
        statistics_.nodes += texels[i + 1];
        statistics_.steps += texels[i + 2];
        statistics_.shadowRays += texels[i + 3] & 0xffffu;
        statistics_.bounceRays += texels[i + 3] >> 16;
    }
}

FrameStatistics Frame::statistics() {
    statistics_.secondsByPass = context_.timer().seconds();
    return statistics_;
}

}  // namespace vitrine
