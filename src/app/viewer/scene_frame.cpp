// SPDX-License-Identifier: MIT
#include "app/viewer/scene_frame.hpp"

#include <algorithm>

#include "frame/check_snippets.hpp"

namespace vitrine {
namespace {

/// A camera before which the whole scene lies, so that all its kinds of things are drawn.
Camera overview(Camera camera, const Aabb& world) {
    if (world.empty()) return camera;
    const glm::vec3 way = camera.eye - camera.target;
    const float length = glm::length(way);
    const glm::vec3 back = length > 0 ? way / length : glm::vec3(0, 0, 1);
    camera.target = world.centre();
    camera.eye = camera.target + 2 * glm::length(world.extent()) * back;
    return camera;
}

}  // namespace

SceneFrame::~SceneFrame() {
    if (frame_ == nullptr) return;
    const ContextUse use(*context_);
    frame_.reset();
}

void SceneFrame::prepare(const LoadedScene& scene, const PackedMoment& moment, const Wish& wish,
                         Extent extent, const Checkpoint& checkpoint) {
    const ContextUse use(*context_);
    try {
        kind_ = kindOf(wish.view);
        counts_ = wish.counting || kind_ == Kind::kCounters;
        extent_ = extent;
        frame_ = std::make_unique<Frame>(*context_, scene.packed, Backend::kAuto, counts_,
                                         FrameOptions{images_, isSketch()});
        frame_->update(moment);
        frame_->callBeforeCompiling(checkpoint);
        compile(wish, moment);
        // A camera that walks asks what it would run into (surroundings.hpp).
        const QueryRay nowhere{wish.camera.eye, 0, {0, 1, 0}, 0};
        if (scene.packed.hasFields && !isSketch()) (void)frame_->closest(std::span(&nowhere, 1));
        frame_->callBeforeCompiling({});
    } catch (const InputError&) {
        // One program reports one snippet's mistakes at best: ask each snippet by itself.
        checkSnippets(*context_, scene.assets).throwIfErrors();
        throw;
    }
}

void SceneFrame::compile(const Wish& wish, const PackedMoment& moment) {
    const auto draw = [&](const Wish& small, FieldFinder finder) {
        FrameRequest request = smallRequestFor(small);
        request.finder = finder;
        frame_->begin(request);
        frame_->drawSample();
        frame_->display();
    };
    Wish moving = wish, still = wish, whole = wish;
    moving.moving = whole.moving = true;
    still.moving = false;
    whole.camera = overview(wish.camera, moment.worldBox);
    draw(moving, FieldFinder::kFaster);
    if (isSketch()) return;
    draw(still, FieldFinder::kFaster);
    draw(whole, FieldFinder::kBoxes);
    // Where fields crowd, and then only, they are found by the tree (frame/first_hits.cpp).
    const auto fields = std::count_if(moment.instances.begin(), moment.instances.end(),
                                      [](const PackedInstance& i) { return i.field; });
    if (fields > 2) draw(whole, FieldFinder::kTree);
}

}  // namespace vitrine
