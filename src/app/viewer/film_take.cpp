// SPDX-License-Identifier: MIT
#include "app/viewer/film_take.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace vitrine {
namespace {

constexpr std::chrono::milliseconds kEncoderWait{20};

}  // namespace

FilmTake::FilmTake(const Context& context, SceneView& view, const FilmSettings& settings)
    : view_(view),
      settings_(settings),
      film_(settings.file, settings.width, settings.height, settings.plan.framesPerSecond),
      drawing_(context, view.scene.loaded().packed, Backend::kAuto, showsCounters(view.view())),
      pilot_(view.pilot) {
    request_.width = settings.width;
    request_.height = settings.height;
    request_.view = view.view();
    begin();
}

/// The frame is drawn as `render` draws it.
void FilmTake::begin() {
    request_.time = settings_.plan.timeOf(frame_);
    drawing_.update(view_.scene.moment(request_.time));
    // A camera that a hand holds stays where it is; the scene's own goes where the scene says.
    pilot_.follow(view_.sceneCamera(), false);
    request_.camera = settings_.plan.cameraOf(frame_, pilot_.camera);
    const RenderSettings& render = view_.scene.posed().render;
    request_.samples = render.samples;
    request_.bounces = render.bounces;
    request_.ssaa = render.ssaa;
    request_.seed = render.seed;
    budgetSeconds_ = render.budgetMilliseconds / 1000;
    drawing_.begin(request_);
}

void FilmTake::step() {
    if (drawn()) film_.waitForEnd(kEncoderWait);
    const FilmThread::State state = film_.state();
    if (state == FilmThread::State::kFailed) throw MachineError(film_.problem());
    written_ = state == FilmThread::State::kWritten;
    if (drawn()) return;
    const auto whole = [this] { return drawing_.samplesDrawn() == request_.samples; };
    // What is shown are whole frames, and at first what there is.
    if (!whole() && drawing_.advance(budgetSeconds_) && (whole() || frame_ == 0))
        picture_ = &drawing_.display();
    if (!whole() || !film_.waitForRoom(kEncoderWait)) return;
    film_.add(drawing_.picture());
    if (++frame_ < settings_.plan.frames())
        begin();
    else
        film_.close();
}

float FilmTake::frameShare() const {
    return static_cast<float>(drawing_.samplesDrawn()) /
           static_cast<float>(std::max(1, request_.samples));
}

}  // namespace vitrine
