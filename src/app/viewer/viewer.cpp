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

#include "app/viewer/handles.hpp"
#include "app/viewer/inspector.hpp"
#include "app/viewer/leaving.hpp"
#include "app/viewer/overlay.hpp"
#include "app/viewer/panel.hpp"
#include "app/viewer/pass_times.hpp"
#include "app/viewer/picture_output.hpp"
#include "app/viewer/playback.hpp"
#include "app/viewer/pointer.hpp"
#include "app/viewer/progress_note.hpp"
#include "app/viewer/recorder.hpp"
#include "app/viewer/scene_files.hpp"
#include "app/viewer/start_page.hpp"
#include "app/viewer/user_folders.hpp"
#include "app/viewer/view_menu.hpp"
#include "app/viewer/walking.hpp"
#include "base/file.hpp"

namespace vitrine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestWait = 0.05;  // s, between looks at the files
// The interface answers an event, and learns the size of a new text, within so many frames.
constexpr int kSettlingFrames = 3;
constexpr float kPanelWidth = 340;  // ImGui units

double secondsSince(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}

/// What the pictures of an older scene leave in the heap, as soon as nothing else is to be done.
void giveMemoryBack() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

/// The user has closed it before there was anything to see. No fault.
struct WindowClosed {};

/// Something to read while the scene is being read, which can be closed.
void showReading(Window& window, const std::string& file, double seconds) {
    window.begin(seconds);
    window.clear();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    drawProgress("reading " + file, {size.x, size.y});
    window.end();
    bool quits = window.takeCloseRequest();
    for (const KeyPress& press : window.takeKeyPresses())
        quits = quits || (press.control && press.key == 'Q');
    if (quits) throw WindowClosed{};
}

std::unique_ptr<Window> openWindow(const ViewOptions& options) {
    auto window = Window::open(options.width, options.height, titleFor(options.file));
    for (int i = 0; i < 2; ++i)  // ImGui learns the size of a text when it draws it first
        showReading(*window, options.file, 0);
    return window;
}

std::filesystem::path recentList() {
    const std::filesystem::path folder = stateFolder();
    return folder.empty() ? folder : folder / "recent";
}

class Viewer {
  public:
    explicit Viewer(const ViewOptions& options)
        : timings_(options.timings),
          window_(openWindow(options)),
          view_(*window_, options.file, options.camera, options.overrides,
                {window_->width() - static_cast<int>(panelWidth()), window_->height()},
                [&] { showReading(*window_, options.file, kLongestWait); }),
          notices_(*window_),
          recent_(recentList()) {
        // Behind those that come later. The menus stand in the order in which they come first.
        auto recorder = std::make_unique<Recorder>(*window_, view_, notices_);
        auto leaving = std::make_unique<Leaving>(*window_, view_, notices_, *recorder);
        auto playback = std::make_unique<Playback>(view_, *recorder);
        leaving_ = leaving.get();
        auto files = std::make_unique<SceneFiles>(*window_, view_, notices_, *leaving_, recent_);
        auto start = std::make_unique<StartPage>(*window_, view_, *files, recent_, options.scenes,
                                                 options.version);
        if (options.startPage)
            start->open();
        else
            recent_.add(options.file);
        tools_.push_back(std::move(files));
        tools_.push_back(std::make_unique<PictureOutput>(view_, notices_));
        tools_.push_back(std::move(recorder));
        tools_.push_back(std::make_unique<ProgressNote>(*window_, view_));
        tools_.push_back(std::make_unique<Inspector>(*window_, view_));
        tools_.push_back(std::make_unique<PassTimes>(*window_, view_));
        tools_.push_back(std::make_unique<Handles>(*window_, view_));
        tools_.push_back(std::make_unique<Pointer>(view_, surroundings_));
        tools_.push_back(std::make_unique<Walking>(view_, surroundings_));
        tools_.push_back(std::move(playback));
        tools_.push_back(std::make_unique<ViewMenu>(view_));
        tools_.push_back(std::move(start));
        tools_.push_back(std::move(leaving));
    }

    int run() {
        while (!closed_) step();
        window_->hide();
        if (timings_ == "-")
            fmt::print("{}", latencies_.table());
        else if (!timings_.empty())
            writeFileAtomically(timings_, latencies_.table());
        return 0;
    }

  private:
    template <class Condition>
    [[nodiscard]] bool anyTool(Condition condition) const {
        return std::any_of(tools_.begin(), tools_.end(),
                           [&](const auto& tool) { return condition(*tool); });
    }

    /// A tool has the scene for itself.
    [[nodiscard]] bool held() const {
        return anyTool([](const Tool& tool) { return tool.holdsScene(); });
    }

    [[nodiscard]] bool works(const Tool& tool) const { return !tool.needsScene() || !held(); }

    void step() {
        const bool busy =
            (!held() && view_.busy()) || anyTool([](const Tool& tool) { return tool.busy(); });
        window_->begin(busy || settling_ > 0 ? 0 : kLongestWait);
        settling_ = window_->hadEvents() ? kSettlingFrames : std::max(0, settling_ - 1);
        const auto elapsed = static_cast<float>(secondsSince(before_));
        before_ = Clock::now();
        const std::vector<Command> commands = listCommands();
        interface(commands);
        takeKeys(commands);
        if (window_->takeCloseRequest()) quit();
        if (!held()) view_.step(elapsed, pictureSize());
        for (const auto& tool : tools_)
            if (works(*tool)) tool->update();
        if (const auto seconds = view_.takeSecondsBehind())
            latencies_.add(Latencies::Kind::kBehind, *seconds);
        if (!busy && settling_ == 0) {
            // Not between a frame that is gone and the first picture of the next one.
            if (!view_.busy() && view_.settle()) giveMemoryBack();
            return window_->skip();
        }
        draw();
        latencies_.add(view_.takeKind(), secondsSince(before_));
    }

    void draw() {
        if (!held())
            view_.draw(window_->width() - static_cast<int>(panelWidth()), window_->height());
        for (const auto& tool : tools_) tool->finishStep();
        window_->clear();
        if (!held()) view_.show();
        for (const auto& tool : tools_) tool->show();
        window_->end();
    }

    void takeKeys(const std::vector<Command>& commands) {
        std::vector<KeyPress> presses = window_->takeKeyPresses();
        if (std::any_of(presses.begin(), presses.end(), [](const auto& p) { return p.control; }))
            view_.pilot.standStill();
        std::erase_if(presses, [this](const KeyPress& press) {  // who is in front comes first
            return std::any_of(tools_.rbegin(), tools_.rend(),
                               [&](const auto& tool) { return tool->takeKey(press); });
        });
        if (!ImGui::GetIO().WantTextInput) runKeys(commands, presses);
    }

    void quit() {
        leaving_->ask([this] { closed_ = true; });
    }

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
        for (const auto& tool : tools_)
            if (works(*tool)) tool->draw(size);
        if (helpShown_) drawHelp(commands);
    }

    void panel(const std::vector<Command>& commands, glm::vec2 size) {
        ImGui::SetNextWindowPos({size.x, 0});
        ImGui::SetNextWindowSize({panelWidth(), size.y});
        ImGui::Begin("Settings", nullptr,
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                         ImGuiWindowFlags_MenuBar);
        ImGui::BeginDisabled(held());
        drawMenus(commands);
        ImGui::TextDisabled("H: all keys     %d of %d samples, %.0f ms", view_.stage.samplesDrawn(),
                            view_.scene.posed().render.samples, 1000 * view_.stage.lastSeconds());
        panel_.draw(view_.scene.loaded().scene, view_.scene.loaded().assets, view_.scene.edits,
                    view_.selection);
        ImGui::EndDisabled();
        ImGui::End();
    }

    std::vector<Command> listCommands() {
        std::vector<Command> list;
        for (const auto& tool : tools_) tool->addCommands(list);
        list.push_back({"File", "Quit", "Ctrl+Q", 'Q', true, false, [this] { quit(); }});
        list.push_back({"View", "Full screen", "F11", kKeyF11, false, false,
                        [this] { window_->setFullScreen(!window_->isFullScreen()); },
                        window_->isFullScreen()});
        list.push_back({"View", "Leave full screen", "Esc", kKeyEscape, false, false,
                        [this] { window_->setFullScreen(false); }});
        list.push_back({"View", "Panel", "Tab", kKeyTab, false, false,
                        [this] { panelShown_ = !panelShown_; }, panelShown_});
        list.push_back({"View", "Keys", "H", 'H', false, false,
                        [this] { helpShown_ = !helpShown_; }, helpShown_});
        return list;
    }

    std::string timings_;
    bool panelShown_ = true;
    Latencies latencies_;
    std::unique_ptr<Window> window_;
    SceneView view_;
    Notices notices_;
    RecentFiles recent_;
    Surroundings surroundings_{view_};
    std::vector<std::unique_ptr<Tool>> tools_;
    Leaving* leaving_ = nullptr;
    bool closed_ = false;
    Panel panel_;
    Clock::time_point before_ = Clock::now();
    int settling_ = kSettlingFrames;
    bool helpShown_ = false;
};

}  // namespace

int view(const ViewOptions& options) {
#ifdef __GLIBC__
    // A software driver keeps images in the heap. Those of scenes that are gone go back to the
    // system, instead of leaving holes that the next ones do not fit.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
    try {
        return Viewer(options).run();
    } catch (const WindowClosed&) {
        return 0;
    }
}

}  // namespace vitrine
