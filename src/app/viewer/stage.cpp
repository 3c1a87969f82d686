// SPDX-License-Identifier: MIT
#include "app/viewer/stage.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "frame/check_snippets.hpp"

namespace vitrine {
namespace {

constexpr int64_t kMostPixels = 16 << 20;

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

void Stage::setScene(const LoadedScene& scene, bool counters) {
    auto next = std::make_unique<Frame>(context_, scene.packed, Backend::kAuto, counters);
    // Compiles all programs while the frame before is still there, if these do not.
    Wish wish = wish_;
    wish.width = std::max(1, wish.width);
    wish.height = std::max(1, wish.height);
    wish.camera = scene.scene.cameras.front();
    wish.moving = true;
    try {
        begin(*next, wish);
        next->drawSample();
        picture_ = &next->display();
    } catch (const InputError&) {
        begun_ = false;
        // One program reports one snippet's mistakes at best: ask each snippet by itself.
        checkSnippets(context_, scene.assets).throwIfErrors();
        throw;
    }
    frame_ = std::move(next);
    counters_ = counters;
    begun_ = finished_ = false;
}

void Stage::update(const PackedMoment& moment) {
    frame_->update(moment);
    begun_ = finished_ = false;
}

void Stage::begin(Frame& frame, const Wish& wish) {
    FrameRequest request;
    drawnScale_ = wish.moving ? pace_.scale() : 1;
    const auto scaled = [&](int size) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(size) * drawnScale_)));
    };
    request.width = scaled(wish.width);
    request.height = scaled(wish.height);
    request.camera = wish.camera;
    request.time = wish.time;
    request.samples = wish.moving ? 1 : wish.samples;
    request.bounces = wish.bounces;
    request.ssaa = wish.moving ? 1 : wish.ssaa;
    // A slider must not take all of the GPU's memory.
    const auto pixels = static_cast<int64_t>(request.width) * request.height;
    while (request.ssaa > 1 && pixels * request.ssaa * request.ssaa > kMostPixels) --request.ssaa;
    request.seed = wish.seed;
    request.view = wish.view;
    request.quick = wish.moving;
    request.timing = measures_;
    passSums_.clear();
    frame.begin(request);
    samplesDrawn_ = 0;
    begun_ = true;
}

void Stage::draw(const Wish& wish, double budgetSeconds) {
    const bool fresh = !begun_ || !same(wish, wish_) || wish_.moving != wish.moving;
    wish_ = wish;
    if (fresh) begin(*frame_, wish);
    const int samples = wish.moving ? 1 : wish.samples;
    finished_ = samplesDrawn_ >= samples;
    if (finished_) return;
    const auto start = std::chrono::steady_clock::now();
    bool whole = true;
    if (wish.moving)
        frame_->drawSample();
    else
        whole = frame_->advance(budgetSeconds);
    if (whole) {
        ++samplesDrawn_;
        finished_ = samplesDrawn_ >= samples;
        picture_ = &frame_->display();
        finishGpu();
        if (measures_) {
            const PassSeconds sums = frame_->statistics().secondsByPass;
            passSeconds_ = difference(sums, passSums_);
            passSums_ = sums;
        }
    }
    lastSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (wish.moving) pace_.took(lastSeconds_, budgetSeconds);
}

void Stage::measure(bool wanted) {
    if (measures_ != wanted) begun_ = finished_ = false;
    measures_ = wanted;
}

std::optional<PassSeconds> Stage::takePassSeconds() {
    return std::exchange(passSeconds_, {});
}

glm::uvec4 Stage::pick(glm::ivec2 pixel) {
    const glm::vec2 share = (glm::vec2(pixel) + 0.5f) / glm::vec2(wish_.width, wish_.height);
    return frame_->pick({share.x, 1 - share.y});
}

}  // namespace vitrine
