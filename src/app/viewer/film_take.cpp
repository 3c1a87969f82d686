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
      stage_(context),
      pilot_(view.pilot) {
    stage_.setScene(view.scene.loaded(), showsCounters(view.view()));
    wish_.width = settings.width;
    wish_.height = settings.height;
    wish_.view = view.view();
    setMoment();
}

/// As SceneView shows a moment.
void FilmTake::setMoment() {
    wish_.time = settings_.plan.timeOf(frame_);
    stage_.update(view_.scene.moment(wish_.time));
    const Scene& posed = view_.scene.posed();
    // A camera that a hand holds stays where it is; the scene's own goes where the scene says.
    pilot_.follow(view_.sceneCamera(), false);
    wish_.camera = settings_.plan.cameraOf(frame_, pilot_.camera);
    wish_.samples = posed.render.samples;
    wish_.bounces = posed.render.bounces;
    wish_.ssaa = posed.render.ssaa;
    wish_.seed = posed.render.seed;
    budgetSeconds_ = posed.render.budgetMilliseconds / 1000;
}

void FilmTake::step() {
    if (drawn()) film_.waitForEnd(kEncoderWait);
    const FilmThread::State state = film_.state();
    if (state == FilmThread::State::kFailed) throw MachineError(film_.problem());
    written_ = state == FilmThread::State::kWritten;
    if (drawn()) return;
    stage_.draw(wish_, budgetSeconds_);
    begun_ = begun_ || stage_.samplesDrawn() > 0;
    if (!stage_.finished() || !film_.waitForRoom(kEncoderWait)) return;
    film_.add(stage_.image());
    if (++frame_ < settings_.plan.frames())
        setMoment();
    else
        film_.close();
}

float FilmTake::frameShare() const {
    return static_cast<float>(stage_.samplesDrawn()) /
           static_cast<float>(std::max(1, wish_.samples));
}

}  // namespace vitrine
