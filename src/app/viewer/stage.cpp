// SPDX-License-Identifier: MIT
#include "app/viewer/stage.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vitrine {
namespace {

bool same(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fov == b.fov &&
           a.focalLength == b.focalLength;
}

bool same(const Stage::Wish& a, const Stage::Wish& b) {
    return a.width == b.width && a.height == b.height && same(a.camera, b.camera) &&
           a.time == b.time && a.view == b.view && a.bounces == b.bounces && a.ssaa == b.ssaa;
}

}  // namespace

void Stage::setScene(const LoadedScene& scene, bool sameSnippets) {
    if (frame_ != nullptr && sameSnippets) {
        frame_->update(scene.packed);
    } else {
        frame_ = std::make_unique<Frame>(context_, scene.packed, Backend::kAuto, true);
        picture_ = nullptr;
    }
    begun_ = false;
}

void Stage::draw(const Wish& wish, double budgetSeconds) {
    const bool fresh = !begun_ || !same(wish, wish_) || (wish_.moving && !wish.moving);
    wish_ = wish;
    if (fresh) {
        FrameRequest request;
        drawnScale_ = wish.moving ? pace_.scale() : 1;
        const auto scaled = [&](int size) {
            return std::max(1,
                            static_cast<int>(std::lround(static_cast<float>(size) * drawnScale_)));
        };
        request.width = scaled(wish.width);
        request.height = scaled(wish.height);
        request.camera = wish.camera;
        request.time = wish.time;
        request.samples = wish.moving ? 1 : wish.samples;
        request.bounces = wish.bounces;
        request.ssaa = wish.moving ? 1 : wish.ssaa;
        request.view = wish.view;
        frame_->begin(request);
        samplesDrawn_ = 0;
        begun_ = true;
    }
    const int samples = wish.moving ? 1 : wish.samples;
    finished_ = samplesDrawn_ >= samples;
    if (finished_) return;
    const auto start = std::chrono::steady_clock::now();
    frame_->drawSample();
    ++samplesDrawn_;
    finished_ = samplesDrawn_ >= samples;
    picture_ = &frame_->display();
    finishGpu();
    lastSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (wish.moving) pace_.took(lastSeconds_, budgetSeconds);
}

}  // namespace vitrine
