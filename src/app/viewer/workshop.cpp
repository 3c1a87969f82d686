// SPDX-License-Identifier: MIT
#include "app/viewer/workshop.hpp"

#include "scene/pose.hpp"

namespace vitrine {
namespace {

PackedMoment momentOf(const LoadedScene& loaded, float time) {
    if (loaded.scene.animations.empty()) return loaded.packed;
    Diagnostics diagnostics;
    PackedMoment moment =
        packMoment(poseScene(loaded.scene, time), loaded.assets, loaded.packed, diagnostics);
    diagnostics.throwIfErrors();
    return moment;
}

}  // namespace

std::shared_ptr<const SharedContext> ContextPool::take() {
    std::unique_ptr<const SharedContext> context;
    {
        const std::lock_guard lock(free_->mutex);
        if (!free_->list.empty()) {
            context = std::move(free_->list.back());
            free_->list.pop_back();
        }
    }
    if (context == nullptr) context = window_.makeContext();
    return {context.release(), [free = free_](const SharedContext* back) {
                const std::lock_guard lock(free->mutex);
                free->list.emplace_back(back);
            }};
}

Workshop::Workshop(Window& window)
    : contexts_(window),
      prober_(FieldProber::Thoroughness::kNeeded, &window.context()),
      background_(&Window::ring) {}

double Workshop::seconds() const {
    return std::chrono::duration<double>(Clock::now() - orderedAt_).count();
}

void Workshop::order(Order order) {
    orderedAt_ = Clock::now();
    Delivery empty;
    // A context to measure fields on is needed in any case.
    empty.frame = std::make_shared<SceneFrame>(contexts_.take(), images_);
    if (order.splitView) empty.splitFrame = std::make_shared<SceneFrame>(contexts_.take(), images_);
    background_.ask([this, at = orderedAt_, order = std::move(order),
                     empty = std::move(empty)](const Checkpoint& checkpoint) mutable {
        Delivery delivery = make(order, std::move(empty), checkpoint);
        delivery.seconds = std::chrono::duration<double>(Clock::now() - at).count();
        return delivery;
    });
}

Workshop::Delivery Workshop::make(Order& order, Delivery delivery, const Checkpoint& checkpoint) {
    std::shared_ptr<const LoadedScene> scene = order.scene;
    try {
        if (order.load) {
            const ContextUse use(delivery.frame->context());
            delivery.load = loadFor(*order.load, prober_, cache_);
            scene = delivery.load->scene;
            if (scene != nullptr) order.moment = momentOf(*scene, order.wish.time);
        }
        checkpoint();
        if (scene != nullptr && order.load) takeSettings(scene->scene.render, order.wish);
        if (scene != nullptr && order.camera)
            order.wish.camera = findCamera(scene->scene, *order.camera);
        const bool counting = order.wish.counting;
        const auto prepare = [&](std::shared_ptr<SceneFrame>& frame, std::optional<View> view,
                                 const PackedMoment& moment, bool counts) {
            if (scene == nullptr || !view) return frame.reset();
            order.wish.view = *view;
            order.wish.counting = counts;
            frame->prepare(*scene, moment, order.wish, checkpoint);
        };
        prepare(delivery.frame, order.view, order.moment, counting);
        prepare(delivery.splitFrame, order.splitView,
                order.load || !order.splitMoment ? order.moment : *order.splitMoment, false);
    } catch (const InputError& error) {
        delivery.problems.append(error.diagnostics());
        delivery.frame.reset();
        delivery.splitFrame.reset();
    }
    return delivery;
}

}  // namespace vitrine
