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

std::string textOf(const char* snippets, const LoadedScene& scene) {
    const auto& includes = scene.packed.shaders.includes;
    const auto found = includes.find(snippets);
    return found == includes.end() ? "" : found->second;
}

constexpr auto kFields = "generated/field.glsl", kMaterials = "generated/material.glsl";

/// What the programs of a sketch are made of.
bool knowsSketch(const CompiledText& compiled, const LoadedScene& scene) {
    return compiled.sketchMaterials == textOf(kMaterials, scene) &&
           compiled.sketchFeatures == featuresOf(scene.packed, false, true);
}

bool canBeSketched(const LoadedScene& scene, const Wish& wish) {
    return scene.packed.hasFields && !showsRecords(wish.view) && !showsCounters(wish.view) &&
           !wish.counting;
}

/// Whether there is to be a sketch first: fields have changed, and nothing else that would have to
/// be compiled for it.
bool wantsSketch(const Workshop::Order& order, const LoadedScene& scene,
                 const CompiledText& compiled) {
    return order.load && !order.load->otherFile && order.view && !order.splitView &&
           canBeSketched(scene, order.wish) && knowsSketch(compiled, scene) &&
           textOf(kFields, scene) != compiled.fields;
}

}  // namespace

std::shared_ptr<const SharedContext> ContextPool::take() {
    std::unique_ptr<const SharedContext> context;
    const auto takeFrom = [&context](List& list) {
        if (context != nullptr || list.empty()) return;
        context = std::move(list.back());
        list.pop_back();
    };
    takeFrom(fresh_);
    {
        const std::lock_guard lock(used_->mutex);
        takeFrom(used_->list);
    }
    if (context == nullptr) context = window_.makeContext();
    return {context.release(), [used = used_](const SharedContext* back) {
                const std::lock_guard lock(used->mutex);
                used->list.emplace_back(back);
            }};
}

bool ContextPool::renew() {
    constexpr size_t kSpare = 2;  // a sketch and the whole of it
    List gone;
    {
        const std::lock_guard lock(used_->mutex);
        gone.swap(used_->list);
    }
    // One at a time: it takes as long as a picture.
    if (gone.empty() && fresh_.size() < kSpare) fresh_.push_back(window_.makeContext());
    return !gone.empty();
}

Workshop::Workshop(Window& window)
    : contexts_(window),
      prober_(FieldProber::Thoroughness::kNeeded, &window.context()),
      changes_(&Window::ring),
      wholes_(&Window::ring) {}

double Workshop::seconds() const {
    return std::chrono::duration<double>(Clock::now() - orderedAt_).count();
}

void Workshop::order(Order order) {
    orderedAt_ = Clock::now();
    Delivery empty;
    // A context to measure fields on is needed in any case.
    empty.frame = std::make_shared<SceneFrame>(contexts_.take(), images_);
    if (order.splitView) empty.splitFrame = std::make_shared<SceneFrame>(contexts_.take(), images_);
    const bool second = order.afterSketch && !order.load;
    if (second) learning_ = false;
    (second ? wholes_ : changes_)
        .ask([this, at = orderedAt_, order = std::move(order), compiled = compiled_,
              empty = std::move(empty)](const Checkpoint& checkpoint) mutable {
            Delivery delivery = make(order, compiled, std::move(empty), checkpoint);
            delivery.seconds = std::chrono::duration<double>(Clock::now() - at).count();
            return delivery;
        });
}

std::optional<Workshop::Delivery> Workshop::take() {
    if (auto delivery = changes_.take()) {
        remember(*delivery);
        return delivery;
    }
    auto delivery = wholes_.take();
    if (!delivery) return {};
    remember(*delivery);
    if (!delivery->learnt) return delivery;
    learning_ = false;
    return {};
}

void Workshop::remember(const Delivery& delivery) {
    if (delivery.frame == nullptr || delivery.scene == nullptr) return;
    if (delivery.frame->isSketch()) {
        compiled_.sketchMaterials = textOf(kMaterials, *delivery.scene);
        compiled_.sketchFeatures = featuresOf(delivery.scene->packed, false, true);
    } else {
        compiled_.fields = textOf(kFields, *delivery.scene);
    }
}

void Workshop::learnSketch(const std::shared_ptr<const LoadedScene>& scene,
                           const PackedMoment& moment, const Wish& wish) {
    if (busy() || learning_ || learntFrom_.lock() == scene || !canBeSketched(*scene, wish)) return;
    learntFrom_ = scene;
    if (knowsSketch(compiled_, *scene)) return;
    learning_ = true;
    auto frame = std::make_shared<SceneFrame>(contexts_.take(), images_);
    wholes_.ask([scene, moment, wish, frame = std::move(frame)](const Checkpoint& checkpoint) {
        Delivery delivery;
        delivery.learnt = true;
        try {
            frame->prepare(*scene, moment, wish, SceneFrame::Extent::kSketch, checkpoint);
            delivery.frame = frame;
            delivery.scene = scene;
        } catch (const InputError&) {
            // Then it goes without.
        }
        return delivery;
    });
}

bool Workshop::settle() {
    images_->settle();
    return !changes_.busy() && !wholes_.busy() && contexts_.renew();
}

Workshop::Delivery Workshop::make(Order& order, const CompiledText& compiled, Delivery delivery,
                                  const Checkpoint& checkpoint) {
    delivery.scene = order.scene;
    try {
        if (order.load) {
            const ContextUse use(delivery.frame->context());
            delivery.load = loadFor(*order.load, prober_, cache_);
            delivery.scene = delivery.load->scene;
            if (delivery.scene != nullptr)
                order.moment = momentOf(*delivery.scene, order.wish.time);
        }
        checkpoint();
        const LoadedScene* scene = delivery.scene.get();
        if (scene != nullptr && order.load) takeSettings(scene->scene.render, order.wish);
        if (scene != nullptr && order.camera)
            order.wish.camera = findCamera(scene->scene, *order.camera);
        if (order.view) order.wish.view = *order.view;
        const auto extent = scene != nullptr && wantsSketch(order, *scene, compiled)
                                ? SceneFrame::Extent::kSketch
                                : SceneFrame::Extent::kWhole;
        const bool counting = order.wish.counting;
        const auto prepare = [&](std::shared_ptr<SceneFrame>& frame, std::optional<View> view,
                                 const PackedMoment& moment, bool counts) {
            if (scene == nullptr || !view) return frame.reset();
            order.wish.view = *view;
            order.wish.counting = counts;
            frame->prepare(*scene, moment, order.wish, extent, checkpoint);
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
