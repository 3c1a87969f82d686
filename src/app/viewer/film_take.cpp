// SPDX-License-Identifier: MIT
#include "app/viewer/film_take.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace vitrine {
namespace {

constexpr std::chrono::milliseconds kEncoderWait{20};

}  // namespace

FilmTake::Side::Side(const Context& context, const LoadedScene& scene, View view, bool isPlain)
    : frame(context, scene.packed, Backend::kAuto, showsCounters(view)), plain(isPlain) {
    request.view = view;
}

FilmTake::FilmTake(const Context& context, SceneView& view, const FilmSettings& settings)
    : view_(view),
      settings_(settings),
      film_(settings.file, settings.width, settings.height, settings.plan.framesPerSecond),
      line_(view.split.line()),
      pilot_(view.pilot) {
    const LoadedScene& scene = view.scene.loaded();
    sides_.push_back(std::make_unique<Side>(context, scene, view.view(), false));
    if (line_)
        sides_.push_back(
            std::make_unique<Side>(context, scene, view.split.view(), view.split.isPlain()));
    begin();
}

void FilmTake::begin() {
    side_ = 0;
    for (const auto& side : sides_) begin(*side);
}

/// The frame is drawn as `render` draws it.
void FilmTake::begin(Side& side) {
    FrameRequest& request = side.request;
    request.width = settings_.width;
    request.height = settings_.height;
    request.time = settings_.plan.timeOf(frame_);
    side.frame.update(side.plain ? view_.scene.momentWithoutEdits(request.time)
                                 : view_.scene.moment(request.time));
    // A camera that a hand holds stays where it is; the scene's own goes where the scene says.
    if (!side.plain) pilot_.follow(view_.sceneCamera(), false);
    const Camera camera = side.plain ? view_.plainCamera(pilot_.camera) : pilot_.camera;
    request.camera = settings_.plan.cameraOf(frame_, camera);
    const RenderSettings& render =
        side.plain ? view_.scene.posedWithoutEdits().render : view_.scene.posed().render;
    request.samples = render.samples;
    request.bounces = render.bounces;
    request.ssaa = render.ssaa;
    request.seed = render.seed;
    if (!side.plain) budgetSeconds_ = render.budgetMilliseconds / 1000;
    side.frame.begin(request);
}

void FilmTake::step() {
    if (drawn()) film_.waitForEnd(kEncoderWait);
    const FilmThread::State state = film_.state();
    if (state == FilmThread::State::kFailed) throw MachineError(film_.problem());
    written_ = state == FilmThread::State::kWritten;
    if (drawn()) return;
    Side& side = *sides_[side_];
    // What is shown are whole frames, and at first what there is.
    if (!side.whole() && side.frame.advance(budgetSeconds_) && (side.whole() || frame_ == 0))
        side.picture = &side.frame.display();
    if (!side.whole()) return;
    if (side_ + 1 < sides_.size()) {
        ++side_;
        return;
    }
    if (!film_.waitForRoom(kEncoderWait)) return;
    ImageRgba8 picture = sides_[0]->frame.picture();
    if (line_) Split::join(picture, sides_[1]->frame.picture(), *line_);
    film_.add(std::move(picture));
    if (++frame_ < settings_.plan.frames())
        begin();
    else
        film_.close();
}

bool FilmTake::show(Window& window, PixelRectangle part) const {
    if (sides_[0]->picture == nullptr) return false;
    window.show(*sides_[0]->picture, part);
    if (!line_ || sides_[1]->picture == nullptr) return true;
    PixelRectangle right = part;
    right.x += Split::columnOf(*line_, part.width);
    right.width = part.x + part.width - right.x;
    window.show(*sides_[1]->picture, part, right);
    return true;
}

float FilmTake::frameShare() const {
    const Side& side = *sides_[side_];
    const float share = static_cast<float>(side.frame.samplesDrawn()) /
                        static_cast<float>(std::max(1, side.request.samples));
    return (static_cast<float>(side_) + share) / static_cast<float>(sides_.size());
}

}  // namespace vitrine
