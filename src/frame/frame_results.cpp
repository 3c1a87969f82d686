// SPDX-License-Identifier: MIT
// What a frame gives: pictures, data, what lies under a pixel, and what it has cost.
#include <algorithm>
#include <utility>

#include "frame/frame.hpp"
#include "frame/sharp_lens.hpp"

namespace vitrine {
namespace {

/// For as long as it lives passes draw what is shown, whatever the supersampling is.
class OutputSize {
  public:
    OutputSize(FrameBlock& block, const FrameRequest& request)
        : block_(block), drawn_(block.image) {
        block.image.x = request.width;
        block.image.y = request.height;
    }
    ~OutputSize() { block_.image = drawn_; }
    OutputSize(const OutputSize&) = delete;
    OutputSize& operator=(const OutputSize&) = delete;

  private:
    FrameBlock& block_;
    glm::ivec4 drawn_;
};

/// The texel at a place of a picture, shares of its width and height.
glm::ivec2 texelAt(const Texture& image, glm::vec2 place) {
    const glm::ivec2 size(image.width(), image.height());
    return glm::clamp(glm::ivec2(place * glm::vec2(size)), glm::ivec2(0), size - 1);
}

}  // namespace

/// The mean of the samples, blurred if that is left to the filter.
const Texture& Frame::finished() {
    if (!filters_) return mean_[0];
    if (blurredSamples_ != sample_)
        for (const Phase phase : {Phase::kHits, Phase::kBlur}) {
            startPhase(phase);
            drawRows(phase, {});
        }
    blurredSamples_ = sample_;
    return lensFilter_->blurred();
}

const Texture& Frame::display() {
    if (request_.view == View::kBvh) {
        // The bounces have overwritten the records. Through the middles of the pixels, so that they
        // fit the lines.
        context_.block.jitter = glm::vec4(0, 0, request_.ssaa, 0);
        const SharpLens sharp(context_.block);
        rasterise();
        findFirstHits();
    }
    const Texture* light = &finished();
    if (!fits(picture_)) picture_ = Texture(request_.width, request_.height, TexelFormat::kRgba8);
    const OutputSize size(context_.block, request_);
    displayPass(context_, *light, picture_);
    if (request_.view == View::kBvh) boxesPass(context_, treeBoxes_, paths_[0].records, picture_);
    previewIsOld_ = true;
    return picture_;
}

bool Frame::fits(const Texture& picture) const {
    return picture.width() == request_.width && picture.height() == request_.height;
}

const Texture* Frame::preview() {
    // The lines of a tree need all of the picture. So does a lens that is a filter: until then all
    // is sharp.
    if (request_.view == View::kBvh || sample_ > 0 || !picture_.valid()) return nullptr;
    if (previewIsOld_ || !fits(preview_)) {
        preview_ = Texture(request_.width, request_.height, TexelFormat::kRgba8);
        preview_.stretch(picture_);
        previewIsOld_ = false;
        previewRows_ = 0;
    }
    const int rows = rowsDone_ / request_.ssaa, height = request_.height;
    const OutputSize size(context_.block, request_);
    context_.rows = {height - rows, height - previewRows_};
    if (rows > previewRows_) displayPass(context_, mean_[1], preview_);
    context_.rows = {};
    previewRows_ = rows;
    return &preview_;
}

glm::uvec4 Frame::pick(glm::vec2 place) {
    // The first hits that are being worked on are overwritten.
    rowsDone_ = previewRows_ = 0;
    if (phase_ == Phase::kBlur) phase_ = Phase::kHits;
    context_.block.jitter = glm::vec4(0, 0, request_.ssaa, 0);
    const SharpLens sharp(context_.block);
    const Texture& records = paths_[0].records;
    const glm::ivec2 texel = texelAt(records, place);
    rasterise();
    context_.rows = {texel.y, texel.y + 1};
    findFirstHits();
    context_.rows = {};
    return records.readUintsAt(texel.x, texel.y);
}

PixelCounts Frame::countsAt(glm::vec2 place) const {
    const glm::ivec2 texel = texelAt(counted_, place);
    const glm::uvec4 counts = counted_.readUintsAt(texel.x, texel.y);
    return {counts.x, counts.y, counts.z, counts.w & 0xffffu, counts.w >> 16};
}

std::vector<glm::uvec4> Frame::closest(std::span<const QueryRay> rays) {
    const FrameBlock block = context_.block;
    std::array<Texture, 2> counters;
    std::swap(counters, context_.counters);
    const PixelRows rows = std::exchange(context_.rows, {});
    const bool timing = std::exchange(context_.timing, false);
    context_.block.cameraEye.w = 0;  // cones do not widen: they are not those of the picture
    queries_.prepare(context_, rays);
    queries_.run(context_, "query_closest");
    context_.block = block;
    context_.rows = rows;
    context_.timing = timing;
    std::swap(counters, context_.counters);
    return queries_.read();
}

ImageRgba8 Frame::picture() {
    display();
    const std::vector<uint8_t> bytes = picture_.readBytes();
    ImageRgba8 image(request_.width, request_.height);
    const size_t row = static_cast<size_t>(request_.width) * 4;
    for (int y = 0; y < request_.height; ++y) {
        const auto* source = bytes.data() + static_cast<size_t>(request_.height - 1 - y) * row;
        std::copy(source, source + row, image.pixels.data() + static_cast<size_t>(y) * row);
    }
    return image;
}

LayerImages Frame::layers() {
    return readLayers(finished(), layers_, request_.ssaa);
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
