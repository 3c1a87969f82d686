// SPDX-License-Identifier: MIT
#include "app/viewer/scene_view.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace vitrine {
namespace {

constexpr double kRestSeconds = 0.15;  // of quiet until the fine picture begins
constexpr double kWatchSeconds = 0.1;  // between looks at the files
constexpr float kFlightSeconds = 0.7f;

double secondsSince(std::chrono::steady_clock::time_point then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

}  // namespace

SceneView::SceneView(Window& window, const std::string& file, const std::string& camera,
                     const std::vector<std::string>& overrides)
    : scene(window.context(), file, overrides),
      stage(window.context()),
      split(window.context()),
      window_(window) {
    const std::vector<Camera>& cameras = scene.loaded().scene.cameras;
    camera_ = static_cast<size_t>(&findCamera(scene.loaded().scene, camera) - cameras.data());
    pilot.take(cameras[camera_], 0);
    showAll();
    scene.problems().throwIfErrors();
}

Diagnostics SceneView::open(const std::string& file) {
    Diagnostics problems = scene.open(file);
    if (problems.hasErrors()) return problems;
    selection = {};
    timeline = {};
    camera_ = 0;
    pilot.take(scene.loaded().scene.cameras.front(), 0);
    showAll();
    return problems;
}

void SceneView::step(float elapsed, glm::vec2 pictureSize) {
    pictureSize_ = pictureSize;
    if (pilot.steer(elapsed, pictureSize)) touch(Latencies::Kind::kTurn);
    if (timeline.advance(elapsed)) showMoment(Latencies::Kind::kPlay);
    follow();
}

void SceneView::draw(int width, int height) {
    const RenderSettings& settings = scene.posed().render;
    wish_.width = std::max(1, width);
    wish_.height = std::max(1, height);
    wish_.camera = pilot.camera;
    wish_.time = timeline.time;
    wish_.view = view_;
    wish_.samples = settings.samples;
    wish_.bounces = settings.bounces;
    wish_.ssaa = settings.ssaa;
    wish_.seed = settings.seed;
    wish_.moving = moving();
    const double budget = settings.budgetMilliseconds / 1000 / (split.isOpen() ? 2 : 1);
    stage.draw(wish_, budget);
    split.draw(wish_, budget);
}

void SceneView::show() {
    if (stage.picture() != nullptr)
        window_.show(*stage.picture(), {0, 0, wish_.width, wish_.height});
    split.show(window_, wish_.width, wish_.height);
}

ImageRgba8 SceneView::image() {
    ImageRgba8 picture = stage.image();
    split.putInto(picture);
    return picture;
}

bool SceneView::busy() const {
    return !stage.finished() || !split.finished() || timeline.playing || pilot.flying() || moving();
}

bool SceneView::moving() const {
    return secondsSince(lastMove_) < kRestSeconds;
}

bool SceneView::finished() const {
    return stage.finished() && split.finished() && !wish_.moving;
}

glm::uvec4 SceneView::pick() {
    note(Latencies::Kind::kPick);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return stage.pick(glm::ivec2(mouse.x, mouse.y));
}

glm::vec3 SceneView::cursorDirection() const {
    return directionThrough(pilot.camera, Pilot::cursor(pictureSize_), viewHeight());
}

void SceneView::showView(View view) {
    view_ = view;
    if (!stage.canShow(view)) showAll();
}

void SceneView::openSplit(View view) {
    try {
        split.open(view, scene.loaded(), scene.moment(timeline.time));
    } catch (const InputError& error) {
        scene.report(error);
    }
}

void SceneView::takeCamera(size_t camera) {
    const std::vector<Camera>& cameras = scene.posed().cameras;
    if (camera >= cameras.size()) return;
    camera_ = camera;
    pilot.take(cameras[camera], kFlightSeconds);
}

const Camera& SceneView::sceneCamera() const {
    const std::vector<Camera>& cameras = scene.posed().cameras;
    return cameras[std::min(camera_, cameras.size() - 1)];
}

Latencies::Kind SceneView::takeKind() {
    return std::exchange(kind_, Latencies::Kind::kRefine);
}

void SceneView::follow() {
    const bool look = secondsSince(lastLook_) >= kWatchSeconds;
    if (look) lastLook_ = Clock::now();
    const bool broken = scene.problems().hasErrors();
    const OpenScene::Change change = scene.follow(look);
    if (change == OpenScene::Change::kAll) showAll();
    if (change == OpenScene::Change::kNumbers) showMoment(Latencies::Kind::kEdit);
    if (change != OpenScene::Change::kNone || broken != scene.problems().hasErrors())
        window_.wake();
}

void SceneView::showAll() {
    try {
        stage.setScene(scene.loaded(), showsCounters(view_));
        split.setScene(scene.loaded());
        timeline.duration = scene.duration();
        showMoment(Latencies::Kind::kReload);
    } catch (const InputError& error) {
        scene.report(error);
    }
}

void SceneView::showMoment(Latencies::Kind why) {
    try {
        moment_ = scene.moment(timeline.time);
        if (!stage.empty()) stage.update(moment_);
        split.update(moment_);
        pilot.follow(sceneCamera(), why != Latencies::Kind::kPlay);
    } catch (const InputError& error) {
        scene.report(error);
    }
    touch(why);
}

/// Something is not as it was in the picture.
void SceneView::touch(Latencies::Kind why) {
    lastMove_ = Clock::now();
    ++changes_;
    note(why);
}

}  // namespace vitrine
