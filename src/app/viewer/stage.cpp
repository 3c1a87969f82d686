// SPDX-License-Identifier: MIT
#include "app/viewer/stage.hpp"

#include <chrono>
#include <utility>

namespace vitrine {
namespace {

bool same(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fov == b.fov &&
           a.focalLength == b.focalLength && a.fStop == b.fStop &&
           a.focusDistance == b.focusDistance && a.apertureBlades == b.apertureBlades &&
           a.lens == b.lens;
}

bool same(const Stage::Wish& a, const Stage::Wish& b) {
    return a.width == b.width && a.height == b.height && same(a.camera, b.camera) &&
           a.time == b.time && a.view == b.view && a.bounces == b.bounces && a.ssaa == b.ssaa &&
           a.samples == b.samples && a.seed == b.seed;
}

}  // namespace

void Stage::setFrame(std::shared_ptr<SceneFrame> frame) {
    picture_ = nullptr;
    frame_ = std::move(frame);
    pace_.takeCareOfNews();
    begun_ = finished_ = false;
}

bool Stage::covers(const PackedMoment& moment) const {
    return frame_ != nullptr && std::as_const(*frame_).frame().covers(moment);
}

void Stage::update(const PackedMoment& moment) {
    const ContextUse use(frame_->context());
    frame_->frame().update(moment);
    begun_ = finished_ = false;
}

void Stage::begin(const Wish& wish) {
    drawnScale_ = wish.moving ? pace_.scale() : 1;
    FrameRequest request = requestFor(wish, drawnScale_);
    request.timing = measures_;
    passSums_.clear();
    frame_->frame().begin(request);
    samplesDrawn_ = 0;
    begun_ = true;
}

void Stage::draw(const Wish& asked, double budgetSeconds) {
    Wish wish = asked;
    // Fine rows come over a coarse picture, and there is always one at once.
    const bool first = picture_ == nullptr && !asked.moving;
    if (first) wish.moving = true;
    const bool fresh = !begun_ || !same(wish, wish_) || wish_.moving != wish.moving;
    wish_ = wish;
    const ContextUse use(frame_->context());
    Frame& frame = frame_->frame();
    if (fresh) begin(wish);
    const int samples = wish.moving || isSketch() ? 1 : wish.samples;
    finished_ = samplesDrawn_ >= samples;
    if (finished_) return;
    const auto start = std::chrono::steady_clock::now();
    bool whole = true;
    if (wish.moving)
        frame.drawSample();
    else
        whole = frame.advance(fresh ? budgetSeconds / 4 : budgetSeconds);  // new images cost, too
    if (whole) {
        ++samplesDrawn_;
        finished_ = samplesDrawn_ >= samples;
        picture_ = &frame.display();
        finishGpu();
        if (measures_) {
            const PassSeconds sums = frame.statistics().secondsByPass;
            passSeconds_ = difference(sums, passSums_);
            passSums_ = sums;
        }
    } else if (const Texture* preview = frame.preview()) {
        picture_ = preview;
        finishGpu();
    }
    lastSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (wish.moving) pace_.took(lastSeconds_, budgetSeconds);
    if (first) finished_ = false;
}

void Stage::measure(bool wanted) {
    if (measures_ != wanted) begun_ = finished_ = false;
    measures_ = wanted;
}

std::optional<PassSeconds> Stage::takePassSeconds() {
    return std::exchange(passSeconds_, {});
}

ImageRgba8 Stage::image() {
    const ContextUse use(frame_->context());
    return frame_->frame().picture();
}

glm::vec2 Stage::placeOf(glm::ivec2 pixel) const {
    const glm::vec2 share = (glm::vec2(pixel) + 0.5f) / glm::vec2(wish_.width, wish_.height);
    return {share.x, 1 - share.y};
}

glm::uvec4 Stage::pick(glm::ivec2 pixel) {
    const ContextUse use(frame_->context());
    return frame_->frame().pick(placeOf(pixel));
}

std::optional<PixelCounts> Stage::counts(glm::ivec2 pixel) {
    if (frame_ == nullptr || !frame_->counts() || !finished_ || wish_.moving) return {};
    const ContextUse use(frame_->context());
    return frame_->frame().countsAt(placeOf(pixel));
}

std::vector<glm::uvec4> Stage::closest(std::span<const QueryRay> rays) {
    const ContextUse use(frame_->context());
    return frame_->frame().closest(rays);
}

}  // namespace vitrine
