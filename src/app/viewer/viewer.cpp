// SPDX-License-Identifier: MIT
#include "app/viewer/viewer.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/viewer/commands.hpp"
#include "app/viewer/open_scene.hpp"
#include "app/viewer/overlay.hpp"
#include "app/viewer/panel.hpp"
#include "app/viewer/pilot.hpp"
#include "app/viewer/stage.hpp"
#include "base/file.hpp"
#include "gpu/window.hpp"
#include "image/png.hpp"
#include "pack/hit_record.hpp"

namespace vitrine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBudget = 0.080;      // s for a frame while something moves
constexpr double kRestSeconds = 0.15;  // of quiet until the fine picture begins
constexpr double kWatchSeconds = 0.1;  // between looks at the files
constexpr double kMessageSeconds = 4;
constexpr float kFlightSeconds = 0.7f;
constexpr int kSettlingFrames = 3;   // the interface answers an event within so many
constexpr float kPanelWidth = 340;   // ImGui units
constexpr float kClickDistance = 3;  // a mouse that moves farther drags

double secondsSince(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}

class Viewer {
  public:
    explicit Viewer(const ViewOptions& options)
        : window_(Window::open(options.width, options.height, "Vitrine")),
          scene_(window_->context(), options.file, options.overrides),
          stage_(window_->context()) {
        pilot_.camera = findCamera(scene_.loaded().scene, options.camera);
        home_ = pilot_.camera;
        window_->setTitle(options.file + " - Vitrine");
        showAll();
        scene_.problems().throwIfErrors();
    }

    int run() {
        while (!window_->shouldClose()) step();
        return 0;
    }

  private:
    void step() {
        const bool busy = !stage_.finished() || timeline_.playing || pilot_.flying() || moving();
        window_->begin(busy || settling_ > 0 ? 0 : kWatchSeconds);
        settling_ = window_->hadEvents() ? kSettlingFrames : std::max(0, settling_ - 1);
        const auto elapsed = static_cast<float>(secondsSince(before_));
        before_ = Clock::now();
        const std::vector<Command> commands = listCommands();
        interface(commands);
        const std::vector<KeyPress> presses = window_->takeKeyPresses();
        if (!ImGui::GetIO().WantTextInput) runKeys(commands, presses);
        if (pilot_.steer(elapsed, pictureSize())) touch();
        click();
        if (timeline_.advance(elapsed)) showMoment();
        follow();
        if (!busy && settling_ == 0 && !changed_) return window_->skip();
        changed_ = false;
        draw();
    }

    void draw() {
        const Stage::Wish w = wish();
        stage_.draw(w, kBudget);
        if (pictureWanted_ && stage_.finished() && !w.moving) writePicture();
        window_->clear();
        if (stage_.picture() != nullptr)
            window_->show(*stage_.picture(), {0, 0, w.width, w.height});
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
        if (change == OpenScene::Change::kNumbers) showMoment();
        if (change != OpenScene::Change::kNone || broken != scene_.problems().hasErrors())
            changed_ = true;
    }

    void showAll() {
        try {
            stage_.setScene(scene_.loaded());
            timeline_.duration = scene_.duration();
            showMoment();
        } catch (const InputError& error) {
            scene_.report(error);
        }
    }

    void showMoment() {
        try {
            const PackedMoment moment = scene_.moment(timeline_.time);
            if (!stage_.empty()) stage_.update(moment);
        } catch (const InputError& error) {
            scene_.report(error);
        }
        touch();
    }

    void touch() { lastMove_ = Clock::now(); }
    [[nodiscard]] bool moving() const { return secondsSince(lastMove_) < kRestSeconds; }

    void say(std::string text) {
        message_ = std::move(text);
        messageAt_ = Clock::now();
        changed_ = true;
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
        drawProblems(scene_.problems(), size);
        if (timeline_.duration > 0 && drawTimeline(timeline_, size)) showMoment();
        if (helpShown_) drawHelp(commands, size);
        if (message_.empty()) return;
        drawMessage(message_, size);
        if (secondsSince(messageAt_) > kMessageSeconds) {
            message_.clear();
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
            {"File", "Save the changes", "Ctrl+S", GLFW_KEY_S, true, false,
             [this] { say(scene_.save()); }},
            {"File", "Write the picture", "F12", GLFW_KEY_F12, false, false,
             [this] {
                 pictureWanted_ = true;
                 say("the picture will be written when it is finished");
             }},
            {"File", "Copy as a command", "Ctrl+Shift+C", GLFW_KEY_C, true, true,
             [this] { copyCommand(); }},
            {"File", "Quit", "Ctrl+Q", GLFW_KEY_Q, true, false, [this] { window_->askToClose(); }},
            {"Edit", "Undo", "Ctrl+Z", GLFW_KEY_Z, true, false, [this] { scene_.edits.undo(); }},
            {"Edit", "Redo", "Ctrl+Y", GLFW_KEY_Y, true, false, [this] { scene_.edits.redo(); }},
            {"View", "Full screen", "F11", GLFW_KEY_F11, false, false,
             [this] { window_->setFullScreen(!window_->isFullScreen()); }, window_->isFullScreen()},
            {"View", "Leave full screen", "Esc", GLFW_KEY_ESCAPE, false, false,
             [this] { window_->setFullScreen(false); }},
            {"View", "Panel", "Tab", GLFW_KEY_TAB, false, false,
             [this] { panelShown_ = !panelShown_; }, panelShown_},
            {"View", "Keys", "H", GLFW_KEY_H, false, false, [this] { helpShown_ = !helpShown_; },
             helpShown_},
            {"Move", "Fly to what is under the cursor", "F", GLFW_KEY_F, false, false,
             [this] { flyToCursor(); }},
            {"Move", "Where the camera was", "Home", GLFW_KEY_HOME, false, false,
             [this] { pilot_.flyTo(home_, kFlightSeconds); }},
        };
        addCameras(list);
        if (timeline_.duration > 0)
            list.push_back({"Move", "Play", "Space", GLFW_KEY_SPACE, false, false,
                            [this] { timeline_.playing = !timeline_.playing; }, timeline_.playing});
        for (size_t i = 0; i < viewNames().size(); ++i)
            list.push_back({"Show", viewNames()[i], "", 0, false, false,
                            [this, i] { view_ = static_cast<View>(i); },
                            view_ == static_cast<View>(i)});
        return list;
    }

    void addCameras(std::vector<Command>& list) {
        const std::vector<Camera>& cameras = scene_.loaded().scene.cameras;
        for (size_t i = 0; i < cameras.size(); ++i) {
            const bool key = i < 9;
            const std::string digit = key ? std::to_string(i + 1) : "";
            list.push_back({"Move", "Camera " + cameras[i].name, digit,
                            key ? GLFW_KEY_1 + static_cast<int>(i) : 0, false, false, [this, i] {
                                const auto& posed = scene_.posed().cameras;
                                if (i >= posed.size()) return;
                                home_ = posed[i];
                                pilot_.flyTo(home_, kFlightSeconds);
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
        if (!record::isSurface(hit)) return;
        const std::string& name = scene_.loaded().packed.instances[hit.x].name;
        const std::vector<Node>& nodes = scene_.loaded().scene.nodes;
        for (size_t i = 0; i < nodes.size(); ++i)
            if (nodes[i].name == name) selection_ = {static_cast<int>(i), true};
    }

    glm::uvec4 pick() {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        return stage_.pick(glm::ivec2(mouse.x, mouse.y));
    }

    void flyToCursor() {
        if (ImGui::GetIO().WantCaptureMouse) return;
        const glm::uvec4 hit = pick();
        if (!record::isSurface(hit)) return;
        const float distance = record::recordDistance(hit);
        const glm::vec3 point =
            pilot_.camera.eye +
            distance * directionThrough(pilot_.camera, Pilot::cursor(pictureSize()));
        // A third of the way remains: near enough to see it, far enough to see where it is.
        const float radius = 0.1f * distance * heightAtUnitDistance(pilot_.camera);
        pilot_.flyTo(lookingAt(pilot_.camera, point, radius), kFlightSeconds);
    }

    // ---- what leaves the window ----

    void copyCommand() {
        const Stage::Wish w = wish();
        const std::string text =
            renderCommand({scene_.file(), pilot_.camera, scene_.overrides(), w.width, w.height,
                           viewNames()[static_cast<size_t>(view_)], timeline_.time});
        ImGui::SetClipboardText(text.c_str());
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

    std::unique_ptr<Window> window_;
    OpenScene scene_;
    Stage stage_;
    Pilot pilot_;
    Camera home_;
    Timeline timeline_;
    Panel panel_;
    Selection selection_;
    View view_ = View::kColor;
    std::string message_;
    Clock::time_point messageAt_{}, before_ = Clock::now(), lastMove_{}, lastLook_{};
    int settling_ = kSettlingFrames;
    bool panelShown_ = true, helpShown_ = false, pictureWanted_ = false;
    bool changed_ = true;  ///< something else than an event asks for a new frame
};

}  // namespace

int view(const ViewOptions& options) {
    return Viewer(options).run();
}

}  // namespace vitrine
