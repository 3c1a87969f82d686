// SPDX-License-Identifier: MIT
#include "app/viewer/viewer.hpp"

#include <fmt/format.h>
#include <imgui.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/viewer/commands.hpp"
#include "app/viewer/inspect.hpp"
#include "app/viewer/latencies.hpp"
#include "app/viewer/open_scene.hpp"
#include "app/viewer/overlay.hpp"
#include "app/viewer/panel.hpp"
#include "app/viewer/pilot.hpp"
#include "app/viewer/split.hpp"
#include "app/viewer/stage.hpp"
#include "base/file.hpp"
#include "gpu/window.hpp"
#include "image/png.hpp"
#include "pack/hit_record.hpp"

namespace vitrine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBudget = 0.070;      // s for a frame while something moves
constexpr double kRestSeconds = 0.15;  // of quiet until the fine picture begins
constexpr double kWatchSeconds = 0.1;  // between looks at the files
constexpr double kMessageSeconds = 4;
constexpr double kRefusalSeconds = 10;
constexpr float kFlightSeconds = 0.7f;
// The interface answers an event, and learns the size of a new text, within so many frames.
constexpr int kSettlingFrames = 3;
constexpr float kPanelWidth = 340;   // ImGui units
constexpr float kClickDistance = 3;  // a mouse that moves farther drags

double secondsSince(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}

std::string titleFor(const std::string& file) {
    return file + " - Vitrine";
}

/// With something to read while the scene is being read.
std::unique_ptr<Window> openWindow(const ViewOptions& options) {
    auto window = Window::open(options.width, options.height, titleFor(options.file));
    for (int i = 0; i < 2; ++i) {  // ImGui learns the size of a text when it draws it first
        window->begin(0);
        window->clear();
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        drawMessage("reading " + options.file, {size.x, size.y});
        window->end();
    }
    return window;
}

class Viewer {
  public:
    explicit Viewer(const ViewOptions& options)
        : timings_(options.timings),
          window_(openWindow(options)),
          scene_(window_->context(), options.file, options.overrides),
          stage_(window_->context()),
          split_(window_->context()) {
        const std::vector<Camera>& cameras = scene_.loaded().scene.cameras;
        camera_ = static_cast<size_t>(&findCamera(scene_.loaded().scene, options.camera) -
                                      cameras.data());
        pilot_.take(cameras[camera_], 0);
        showAll();
        scene_.problems().throwIfErrors();
    }

    int run() {
        while (!window_->shouldClose()) step();
        if (timings_ == "-")
            fmt::print("{}", latencies_.table());
        else if (!timings_.empty())
            writeFileAtomically(timings_, latencies_.table());
        return 0;
    }

  private:
    void step() {
        const bool busy = !stage_.finished() || !split_.finished() || timeline_.playing ||
                          pilot_.flying() || moving();
        window_->begin(busy || settling_ > 0 ? 0 : kWatchSeconds);
        settling_ = window_->hadEvents() ? kSettlingFrames : std::max(0, settling_ - 1);
        const auto elapsed = static_cast<float>(secondsSince(before_));
        before_ = Clock::now();
        kind_ = Latencies::Kind::kRefine;
        takeDrop();
        const std::vector<Command> commands = listCommands();
        interface(commands);
        const std::vector<KeyPress> presses = window_->takeKeyPresses();
        if (!ImGui::GetIO().WantTextInput) runKeys(commands, presses);
        if (pilot_.steer(elapsed, pictureSize())) touch(Latencies::Kind::kTurn);
        click();
        if (timeline_.advance(elapsed)) showMoment(Latencies::Kind::kPlay);
        follow();
        inspectCursor();
        if (!busy && settling_ == 0) return window_->skip();
        draw();
        latencies_.add(kind_, secondsSince(before_));
    }

    void draw() {
        const Stage::Wish w = wish();
        const double budget = split_.isOpen() ? kBudget / 2 : kBudget;
        stage_.draw(w, budget);
        split_.draw(w, budget);
        if (pictureWanted_ && stage_.finished() && !w.moving) writePicture();
        window_->clear();
        if (stage_.picture() != nullptr)
            window_->show(*stage_.picture(), {0, 0, w.width, w.height});
        split_.show(*window_, w.width, w.height);
        window_->end();
    }

    [[nodiscard]] Stage::Wish wish() const {
        const RenderSettings& settings = scene_.posed().render;
        Stage::Wish w;
        w.width = std::max(1, window_->width() - static_cast<int>(panelWidth()));
        w.height = std::max(1, window_->height());
        w.camera = pilot_.camera;
        w.time = timeline_.time;
        w.view = view_;
        w.samples = settings.samples;
        w.bounces = settings.bounces;
        w.ssaa = settings.ssaa;
        w.seed = settings.seed;
        w.moving = moving();
        return w;
    }

    // ---- what changes ----

    void follow() {
        const bool look = secondsSince(lastLook_) >= kWatchSeconds;
        if (look) lastLook_ = Clock::now();
        const bool broken = scene_.problems().hasErrors();
        const OpenScene::Change change = scene_.follow(look);
        if (change == OpenScene::Change::kAll) showAll();
        if (change == OpenScene::Change::kNumbers) showMoment(Latencies::Kind::kEdit);
        if (change != OpenScene::Change::kNone || broken != scene_.problems().hasErrors())
            settling_ = kSettlingFrames;
    }

    /// Opens the first of the files that were dropped on the window.
    void takeDrop() {
        const std::vector<std::string> files = window_->takeDroppedFiles();
        if (files.empty()) return;
        const std::string& file = files.front();
        refusedAt_ = Clock::now();
        // What has been changed by hand is lost only to who drops the file twice.
        if (!scene_.edits.empty() && droppedBefore_ != file) {
            droppedBefore_ = file;
            refusal_ = {};
            refusal_.error({scene_.file()},
                           "has changes that are not saved: drop the file again to lose them");
            return;
        }
        droppedBefore_.clear();
        refusal_ = scene_.open(file);
        if (refusal_.hasErrors()) return;
        window_->setTitle(titleFor(file));
        selection_ = {};
        timeline_ = {};
        camera_ = 0;
        pilot_.take(scene_.loaded().scene.cameras.front(), 0);
        showAll();
        say(files.size() == 1 ? "opened " + file
                              : fmt::format("opened {}, the first of {}", file, files.size()));
    }

    void showAll() {
        try {
            stage_.setScene(scene_.loaded(), showsCounters(view_));
            split_.setScene(scene_.loaded());
            timeline_.duration = scene_.duration();
            showMoment(Latencies::Kind::kReload);
        } catch (const InputError& error) {
            scene_.report(error);
        }
    }

    void showMoment(Latencies::Kind why) {
        try {
            moment_ = scene_.moment(timeline_.time);
            if (!stage_.empty()) stage_.update(moment_);
            split_.update(moment_);
            const std::vector<Camera>& cameras = scene_.posed().cameras;
            pilot_.follow(cameras[std::min(camera_, cameras.size() - 1)],
                          why != Latencies::Kind::kPlay);
        } catch (const InputError& error) {
            scene_.report(error);
        }
        touch(why);
    }

    /// Something is not as it was in the picture.
    void touch(Latencies::Kind why) {
        lastMove_ = Clock::now();
        inspected_.reset();
        note(why);
    }
    void note(Latencies::Kind why) { kind_ = std::max(kind_, why); }
    [[nodiscard]] bool moving() const { return secondsSince(lastMove_) < kRestSeconds; }

    void say(std::string text) {
        message_ = std::move(text);
        messageAt_ = Clock::now();
        settling_ = kSettlingFrames;
    }

    // ---- the interface ----

    [[nodiscard]] float panelWidth() const {
        return panelShown_ ? std::floor(kPanelWidth * window_->scale()) : 0;
    }

    [[nodiscard]] glm::vec2 pictureSize() const {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        return {std::max(1.0f, size.x - panelWidth()), std::max(1.0f, size.y)};
    }

    void interface(const std::vector<Command>& commands) {
        const glm::vec2 size = pictureSize();
        if (panelShown_) panel(commands, size);
        split_.drawLine(size, nameOf(view_), nameOf(split_.view()));
        problems(size);
        if (timeline_.duration > 0 && drawTimeline(timeline_, size))
            showMoment(Latencies::Kind::kPlay);
        if (inspectorShown_) drawFacts(facts_, size);
        if (helpShown_) drawHelp(commands, size);
        if (message_.empty()) return;
        drawMessage(message_, size);
        if (secondsSince(messageAt_) > kMessageSeconds) {
            message_.clear();
            settling_ = kSettlingFrames;
        }
    }

    void problems(glm::vec2 size) {
        if (scene_.problems().hasErrors())
            return drawProblems(scene_.problems(),
                                "The last good picture stays until the file is mended.", size);
        if (!refusal_.hasErrors()) return;
        drawProblems(refusal_, "The scene stays as it is.", size);
        if (secondsSince(refusedAt_) > kRefusalSeconds) {
            refusal_ = {};
            settling_ = kSettlingFrames;
        }
    }

    void panel(const std::vector<Command>& commands, glm::vec2 size) {
        ImGui::SetNextWindowPos({size.x, 0});
        ImGui::SetNextWindowSize({panelWidth(), size.y});
        ImGui::Begin("Settings", nullptr,
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                         ImGuiWindowFlags_MenuBar);
        drawMenus(commands);
        ImGui::TextDisabled("H: all keys     %d of %d samples, %.0f ms", stage_.samplesDrawn(),
                            scene_.posed().render.samples, 1000 * stage_.lastSeconds());
        panel_.draw(scene_.loaded().scene, scene_.loaded().assets, scene_.edits, selection_);
        ImGui::End();
    }

    std::vector<Command> listCommands() {
        std::vector<Command> list{
            {"File", "Save the changes", "Ctrl+S", 'S', true, false,
             [this] { say(scene_.save()); }},
            {"File", "Write the picture", "F12", kKeyF12, false, false,
             [this] {
                 pictureWanted_ = true;
                 say("the picture will be written when it is finished");
             }},
            {"File", "Copy as a command", "Ctrl+Shift+C", 'C', true, true,
             [this] { copyCommand(); }},
            {"File", "Quit", "Ctrl+Q", 'Q', true, false, [this] { window_->askToClose(); }},
            {"Edit", "Undo", "Ctrl+Z", 'Z', true, false, [this] { scene_.edits.undo(); }},
            {"Edit", "Redo", "Ctrl+Y", 'Y', true, false, [this] { scene_.edits.redo(); }},
            {"View", "Full screen", "F11", kKeyF11, false, false,
             [this] { window_->setFullScreen(!window_->isFullScreen()); }, window_->isFullScreen()},
            {"View", "Leave full screen", "Esc", kKeyEscape, false, false,
             [this] { window_->setFullScreen(false); }},
            {"View", "Panel", "Tab", kKeyTab, false, false, [this] { panelShown_ = !panelShown_; },
             panelShown_},
            {"View", "What is under the cursor", "I", 'I', false, false,
             [this] {
                 inspectorShown_ = !inspectorShown_;
                 inspected_.reset();
             },
             inspectorShown_},
            {"View", "Keys", "H", 'H', false, false, [this] { helpShown_ = !helpShown_; },
             helpShown_},
            {"Move", "Fly to what is under the cursor", "F", 'F', false, false,
             [this] { flyToCursor(); }},
            {"Move", "Where the camera was", "Home", kKeyHome, false, false,
             [this] { pilot_.goHome(kFlightSeconds); }},
        };
        addCameras(list);
        if (timeline_.duration > 0)
            list.push_back({"Move", "Play", "Space", ' ', false, false,
                            [this] { timeline_.playing = !timeline_.playing; }, timeline_.playing});
        for (size_t i = 0; i < viewNames().size(); ++i)
            list.push_back({"Show", viewNames()[i], "", 0, false, false,
                            [this, i] { showView(static_cast<View>(i)); },
                            view_ == static_cast<View>(i)});
        addSplit(list);
        return list;
    }

    void addSplit(std::vector<Command>& list) {
        list.push_back({"Split", "Split the picture", "V", 'V', false, false,
                        [this] { split_.isOpen() ? split_.close() : openSplit(split_.view()); },
                        split_.isOpen()});
        for (size_t i = 0; i < viewNames().size(); ++i) {
            const auto view = static_cast<View>(i);
            list.push_back({"Split", "right: " + viewNames()[i], "", 0, false, false,
                            [this, view] { openSplit(view); },
                            split_.isOpen() && split_.view() == view});
        }
    }

    void showView(View view) {
        view_ = view;
        if (!stage_.canShow(view)) showAll();
    }

    void openSplit(View view) {
        try {
            split_.open(view, scene_.loaded(), scene_.moment(timeline_.time));
        } catch (const InputError& error) {
            scene_.report(error);
        }
    }

    static const std::string& nameOf(View view) { return viewNames()[static_cast<size_t>(view)]; }

    void addCameras(std::vector<Command>& list) {
        const std::vector<Camera>& cameras = scene_.loaded().scene.cameras;
        for (size_t i = 0; i < cameras.size(); ++i) {
            const bool key = i < 9;
            const std::string digit = key ? std::to_string(i + 1) : "";
            list.push_back({"Move", "Camera " + cameras[i].name, digit,
                            key ? '1' + static_cast<int>(i) : 0, false, false, [this, i] {
                                const auto& posed = scene_.posed().cameras;
                                if (i >= posed.size()) return;
                                camera_ = i;
                                pilot_.take(posed[i], kFlightSeconds);
                            }});
        }
    }

    // ---- the scene under the cursor ----

    void click() {
        const ImGuiIO& io = ImGui::GetIO();
        if (io.WantCaptureMouse) return;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return flyToCursor();
        const ImVec2 way = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0);
        const bool still = std::abs(way.x) + std::abs(way.y) < kClickDistance;
        if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left) || !still) return;
        selection_ = {-1, false};
        const glm::uvec4 hit = pick();
        if (!record::isSurface(hit) || hit.x >= moment_.instances.size()) return;
        const std::string& name = moment_.instances[hit.x].name;
        const std::vector<Node>& nodes = scene_.loaded().scene.nodes;
        for (size_t i = 0; i < nodes.size(); ++i)
            if (nodes[i].name == name) selection_ = {static_cast<int>(i), true};
    }

    glm::uvec4 pick() {
        note(Latencies::Kind::kPick);
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        return stage_.pick(glm::ivec2(mouse.x, mouse.y));
    }

    [[nodiscard]] glm::vec3 cursorDirection() const {
        const glm::vec2 size = pictureSize();
        return directionThrough(pilot_.camera, Pilot::cursor(size), pilot_.viewHeight(size));
    }

    /// Looks when the cursor or the picture is another, and then only at a picture that rests.
    void inspectCursor() {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const glm::ivec2 pixel(mouse.x, mouse.y);
        if (!inspectorShown_ || moving() || inspected_ == pixel) return;
        if (ImGui::GetIO().WantCaptureMouse || !ImGui::IsMousePosValid()) return;
        inspected_ = pixel;
        facts_ =
            inspect(scene_.loaded().packed, moment_, pick(), pilot_.camera.eye, cursorDirection());
        facts_.emplace(facts_.begin(), "pixel", fmt::format("{}  {}", pixel.x, pixel.y));
        settling_ = kSettlingFrames;
    }

    void flyToCursor() {
        if (ImGui::GetIO().WantCaptureMouse) return;
        const glm::uvec4 hit = pick();
        if (!record::isSurface(hit)) return;
        const float distance = record::recordDistance(hit);
        const float height = pilot_.viewHeight(pictureSize());
        const glm::vec3 point = pilot_.camera.eye + distance * cursorDirection();
        // A third of the way remains: near enough to see it, far enough to see where it is.
        const float radius = 0.1f * distance * height;
        pilot_.flyTo(lookingAt(pilot_.camera, point, radius, height), kFlightSeconds);
    }

    // ---- what leaves the window ----

    void copyCommand() {
        const Stage::Wish w = wish();
        const std::string text =
            renderCommand({scene_.file(), pilot_.camera, scene_.overrides(), w.width, w.height,
                           viewNames()[static_cast<size_t>(view_)], timeline_.time});
        ImGui::SetClipboardText(text.c_str());
        // Not every clipboard outlives the window.
        fmt::print("{}\n", text);
        std::fflush(stdout);
        say("copied: " + text);
    }

    void writePicture() {
        pictureWanted_ = false;
        try {
            const std::string name = nextPictureName("vitrine");
            writeFileAtomically(name, encodePng(stage_.image(), {}));
            say("wrote " + name);
        } catch (const MachineError& error) {
            say(error.what());
        }
    }

    std::string timings_;
    Latencies latencies_;
    Latencies::Kind kind_ = Latencies::Kind::kRefine;
    std::unique_ptr<Window> window_;
    OpenScene scene_;
    Stage stage_;
    Split split_;
    Pilot pilot_;
    size_t camera_ = 0;  ///< in Scene::cameras: the one that the pilot has taken
    Timeline timeline_;
    PackedMoment moment_;                  ///< what the stage shows
    std::optional<glm::ivec2> inspected_;  ///< the pixel that the facts are of
    Facts facts_;
    Panel panel_;
    Selection selection_;
    View view_ = View::kColor;
    Diagnostics refusal_;        ///< why the file that was dropped is not shown
    std::string droppedBefore_;  ///< and not opened, for the sake of edits
    std::string message_;
    Clock::time_point messageAt_{}, refusedAt_{}, before_ = Clock::now(), lastMove_{}, lastLook_{};
    int settling_ = kSettlingFrames;
    bool panelShown_ = true, helpShown_ = false, inspectorShown_ = false, pictureWanted_ = false;
};

}  // namespace

int view(const ViewOptions& options) {
#ifdef __GLIBC__
    // A software driver keeps images in the heap. Those of scenes that are gone go back to the
    // system, instead of leaving holes that the next ones do not fit.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
    return Viewer(options).run();
}

}  // namespace vitrine
