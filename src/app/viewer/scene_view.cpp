// SPDX-License-Identifier: MIT
#include "app/viewer/scene_view.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace vitrine {
namespace {

constexpr double kRestSeconds = 0.15;   // of quiet until the fine picture begins
constexpr double kWatchSeconds = 0.05;  // between looks at the files
constexpr double kQuietSeconds = 0.3;   // until it is said that something is being made
constexpr float kFlightSeconds = 0.7f;

double secondsSince(std::chrono::steady_clock::time_point then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

}  // namespace

SceneView::SceneView(Window& window, const std::string& file, const std::string& camera,
                     const std::vector<std::string>& overrides, glm::ivec2 pixels,
                     const std::function<void()>& wait)
    : workshop_(window), scene(file, overrides), window_(window) {
    wish_.width = std::max(1, pixels.x);
    wish_.height = std::max(1, pixels.y);
    order(scene.request(), camera);
    std::optional<Workshop::Delivery> delivery;
    while (!(delivery = workshop_.take())) wait();
    accept(std::move(*delivery));
    scene.problems().throwIfErrors();
}

void SceneView::open(const std::string& file) {
    if (canOpen(file)) return order(OpenScene::requestFor(file), "");
    opened_ = Opened{file, {}};
    opened_->problems.error({file},
                            "not a file that can be shown: .toml, .glb, .gltf, .obj, .sdf.glsl");
}

std::string SceneView::pending() const {
    if (!workshop_.busy() || workshop_.seconds() < kQuietSeconds) return "";
    return reading_ && reading_->otherFile ? "reading " + reading_->file : "compiling";
}

void SceneView::step(float elapsed, glm::vec2 pictureSize) {
    pictureSize_ = pictureSize;
    if (pilot.steer(elapsed, pictureSize)) touch(Latencies::Kind::kTurn);
    // A camera that is held does not go, and without it the picture would never be still.
    if (pilot.held() && scene.movesAlone(camera_)) timeline.playing = false;
    if (timeline.advance(elapsed)) showMoment(Latencies::Kind::kPlay);
    follow();
    if (stage.samplesDrawn() > 0) workshop_.learnSketch(scene.shared(), moment_, wish_);
}

void SceneView::draw(int width, int height) {
    const RenderSettings& settings = scene.posed().render;
    takeSettings(settings, wish_);
    wish_.width = std::max(1, width);
    wish_.height = std::max(1, height);
    wish_.camera = pilot.camera;
    wish_.time = timeline.time;
    if (stage.canShow(view_, counting_)) shown_ = view_;
    wish_.view = shown_;
    wish_.moving = moving();
    const double budget = settings.budgetMilliseconds / 1000 / (split.isOpen() ? 2 : 1);
    stage.draw(wish_, budget);
    split.draw(split.isPlain() ? plainWish() : wish_, budget);
}

/// From the same place, with the lens and the settings that the file says.
Stage::Wish SceneView::plainWish() const {
    const Scene& plain = scene.posedWithoutEdits();
    Stage::Wish wish = wish_;
    takeSettings(plain.render, wish);
    wish.camera = plainCamera(pilot.camera);
    return wish;
}

Camera SceneView::plainCamera(const Camera& place) const {
    const std::vector<Camera>& cameras = scene.posedWithoutEdits().cameras;
    Camera camera = cameras[std::min(camera_, cameras.size() - 1)];
    camera.eye = place.eye;
    camera.target = place.target;
    camera.up = place.up;
    return camera;
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
    return !stage.finished() || !split.finished() || timeline.playing || pilot.flying() ||
           moving() || wish_.moving;  // the last picture was coarse
}

bool SceneView::moving() const {
    return secondsSince(lastMove_) < kRestSeconds;
}

bool SceneView::finished() const {
    return stage.finished() && split.finished() && !wish_.moving && !workshop_.busy();
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
    if (split.isPlain()) split.open(view, true);
    orderMissingFrames();
}

void SceneView::countRays(bool wanted) {
    counting_ = wanted;
    orderMissingFrames();
}

std::optional<PixelCounts> SceneView::countsUnderMouse() {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return stage.counts(glm::ivec2(mouse.x, mouse.y));
}

void SceneView::openSplit(View view, bool plain) {
    split.open(view, plain);
    showMoment(Latencies::Kind::kEdit);
}

void SceneView::takeCamera(size_t camera) {
    const std::vector<Camera>& cameras = scene.posed().cameras;
    if (camera >= cameras.size()) return;
    lookThrough(cameras[camera], camera, kFlightSeconds);
}

void SceneView::lookThrough(const Camera& camera, size_t index, float seconds) {
    camera_ = index;
    pilot.take(camera, seconds);
    timeline.fit(scene.timeSpan(camera_));
    // Who wants to see through a camera that goes round wants to see it go.
    if (scene.moves(camera_)) timeline.playing = true;
}

void SceneView::play(bool on) {
    timeline.playing = on;
    if (on && pilot.held() && scene.movesAlone(camera_)) goHome();
}

const Camera& SceneView::sceneCamera() const {
    const std::vector<Camera>& cameras = scene.posed().cameras;
    return cameras[std::min(camera_, cameras.size() - 1)];
}

Latencies::Kind SceneView::takeKind() {
    return std::exchange(kind_, Latencies::Kind::kRefine);
}

void SceneView::follow() {
    if (auto delivery = workshop_.take()) accept(std::move(*delivery));
    // Another file that is being opened is not given up for changes of this one.
    const bool opening = reading_ && reading_->otherFile;
    const bool look = !opening && secondsSince(lastLook_) >= kWatchSeconds;
    if (look) lastLook_ = Clock::now();
    const bool broken = scene.problems().hasErrors();
    const OpenScene::Change change = scene.follow(look);
    if (change == OpenScene::Change::kMustRead && !opening) order(scene.request());
    if (change == OpenScene::Change::kNumbers) showMoment(Latencies::Kind::kEdit);
    if (change == OpenScene::Change::kNumbers || broken != scene.problems().hasErrors())
        window_.wake();
}

/// What was ordered to be read and is not there is ordered again with anything else.
void SceneView::order(std::optional<LoadRequest> load, std::optional<std::string> camera) {
    if (load) {
        reading_ = std::move(load);
        readingCamera_ = std::move(camera);
    }
    Workshop::Order order;
    order.load = reading_;
    order.camera = readingCamera_;
    order.wish = wish_;
    order.wish.counting = counting_;
    order.wish.camera = pilot.camera;
    order.wish.time = reading_ && reading_->otherFile ? 0 : timeline.time;
    order.afterSketch = stage.isSketch();
    if (!reading_) {
        order.scene = scene.shared();
        order.moment = moment_;
        order.splitMoment = plainMoment_;
    }
    if (reading_ || needsFrame()) order.view = view_;
    if (split.isOpen() && (reading_ || split.needsFrame() || !split.covers(splitMoment())))
        order.splitView = split.view();
    workshop_.order(std::move(order));
}

void SceneView::orderMissingFrames() {
    // Those of a scene that is being read come with it.
    if (needsFrame() || split.needsFrame() || !split.covers(splitMoment())) order({});
}

bool SceneView::needsFrame() const {
    return !stage.canShow(view_, counting_) || !stage.covers(moment_) || stage.isSketch();
}

void SceneView::accept(Workshop::Delivery delivery) {
    window_.wake();
    if (!delivery.load) {
        // A whole frame may come late, when the scene is another one already.
        if (delivery.scene != scene.shared()) return;
        if (delivery.problems.hasErrors()) return scene.report(InputError(delivery.problems));
        return showDelivered(delivery);
    }
    const LoadRequest request = delivery.load->request;
    const bool first = stage.empty();
    if (reading_ && reading_->number == request.number) reading_.reset();
    if (request.otherFile) {
        opened_ = Opened{request.file, delivery.load->problems};
        opened_->problems.append(delivery.problems);
    }
    const bool taken = scene.take(std::move(*delivery.load), delivery.problems);
    if (request.otherFile) {
        if (!taken && scene.isWaiting()) order(scene.request());
        if (!taken) return;
        selection = {};
    }
    if (!taken) return;
    if (first || request.otherFile) {
        const std::vector<Camera>& cameras = scene.loaded().scene.cameras;
        const std::string name = readingCamera_.value_or("");
        const Camera& camera = findCamera(scene.loaded().scene, name);
        timeline = {};
        lookThrough(camera, static_cast<size_t>(&camera - cameras.data()), 0);
        const TimeSpan span = scene.timeSpan(camera_);
        timeline.loop = span.hasKeys || !span.endless;
        readingCamera_.reset();
    }
    showDelivered(delivery);
}

void SceneView::showDelivered(Workshop::Delivery& delivery) {
    if (delivery.load || !stage.isSketch()) secondsBehind_ = delivery.seconds;
    if (delivery.frame != nullptr) stage.setFrame(std::move(delivery.frame));
    if (delivery.splitFrame != nullptr) split.setFrame(std::move(delivery.splitFrame));
    showMoment(Latencies::Kind::kReload);
}

void SceneView::showMoment(Latencies::Kind why) {
    try {
        timeline.fit(scene.timeSpan(camera_));
        moment_ = scene.moment(timeline.time);
        plainMoment_.reset();
        if (split.isPlain()) plainMoment_ = scene.momentWithoutEdits(timeline.time);
        ++moments_;
        if (stage.covers(moment_)) stage.update(moment_);
        if (split.covers(splitMoment())) split.update(splitMoment());
        // What is still being made may be of the scene before, not of one that has just come.
        if (!workshop_.busy() || (why == Latencies::Kind::kReload && !reading_))
            orderMissingFrames();
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
