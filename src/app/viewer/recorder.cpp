// SPDX-License-Identifier: MIT
#include "app/viewer/recorder.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vitrine {
namespace {

constexpr std::array<int, 4> kRates{24, 25, 30, 60};
/// The first one is the window's.
constexpr std::array<std::array<int, 2>, 3> kSizes{{{0, 0}, {1280, 720}, {1920, 1080}}};
constexpr float kLongestFilm = 3600;    // s
constexpr float kStillFilmSeconds = 6;  // of a scene that does not say how long it is

}  // namespace

std::string clockText(double seconds) {
    const auto s = static_cast<int64_t>(std::ceil(std::clamp(seconds, 0.0, 3.6e6)));
    if (s < 3600) return fmt::format("{}:{:02}", s / 60, s % 60);
    return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

void Recorder::addCommands(std::vector<Command>& list) {
    list.push_back({"File", "Record a film", "Ctrl+R", 'R', true, false, [this] { ask(); }});
}

void Recorder::ask() {
    if (isRecording()) return;
    if (plannedFor_ != view_.scene.file()) {
        plannedFor_ = view_.scene.file();
        const float duration = view_.timeline.duration;
        plan_.what = duration > 0 ? FilmPlan::What::kTime : FilmPlan::What::kTurn;
        plan_.from = 0;
        plan_.seconds = duration > 0 ? duration : kStillFilmSeconds;
    }
    view_.timeline.playing = false;
    question_.open();
}

FilmSettings Recorder::settings() const {
    FilmSettings result;
    result.plan = plan_;
    result.plan.framesPerSecond = kRates[static_cast<size_t>(choice_.rate)];
    if (plan_.what == FilmPlan::What::kTurn) result.plan.from = view_.timeline.time;
    result.file = nextFileName(choice_.webm ? ".webm" : ".mp4");
    const auto [width, height] = kSizes[static_cast<size_t>(choice_.size)];
    // Films have even sizes: both codecs keep colours for two by two pixels.
    const auto even = [](int size) { return std::max(2, size / 2 * 2); };
    result.width = width > 0 ? width : even(view_.wish().width);
    result.height = height > 0 ? height : even(view_.wish().height);
    return result;
}

void Recorder::draw(glm::vec2 pictureSize) {
    drawQuestion();
    if (!isRecording()) return;
    drawProgress(pictureSize);
    ImGui::GetIO().WantCaptureMouse = true;  // the camera stands still
}

void Recorder::drawQuestion() {
    if (!question_.begin()) return;
    drawChoices();
    ImGui::Separator();
    const FilmSettings s = settings();
    const int samples = view_.scene.posed().render.samples;
    ImGui::TextDisabled("%d frames of %d sample%s each, to %s", s.plan.frames(), samples,
                        samples == 1 ? "" : "s", s.file.c_str());
    const bool go = question_.answer("Record");
    question_.end(go, go);
    if (go) start();
}

void Recorder::drawChoices() {
    int what = static_cast<int>(plan_.what);
    ImGui::RadioButton("time passes", &what, static_cast<int>(FilmPlan::What::kTime));
    ImGui::SameLine();
    ImGui::RadioButton("the camera turns once around its target", &what,
                       static_cast<int>(FilmPlan::What::kTurn));
    plan_.what = static_cast<FilmPlan::What>(what);

    ImGui::PushItemWidth(6 * ImGui::GetFontSize());
    const auto field = [](const char* text, const char* id, float& seconds) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(text);
        ImGui::SameLine();
        ImGui::InputFloat(id, &seconds, 0, 0, "%.2f s");
    };
    if (plan_.what == FilmPlan::What::kTime) {
        field("from", "##from", plan_.from);
        plan_.from = std::isfinite(plan_.from) ? std::clamp(plan_.from, 0.0f, kLongestFilm) : 0;
        ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    }
    field("for", "##for", plan_.seconds);
    plan_.seconds = std::isfinite(plan_.seconds) ? std::clamp(plan_.seconds, 0.0f, kLongestFilm)
                                                 : kStillFilmSeconds;
    ImGui::PopItemWidth();

    for (size_t i = 0; i < kRates.size(); ++i) {
        ImGui::RadioButton(fmt::format("{}", kRates[i]).c_str(), &choice_.rate,
                           static_cast<int>(i));
        ImGui::SameLine();
    }
    ImGui::TextUnformatted("frames a second");

    for (size_t i = 0; i < kSizes.size(); ++i) {
        const glm::ivec2 size(kSizes[i][0] > 0 ? kSizes[i][0] : view_.wish().width / 2 * 2,
                              kSizes[i][1] > 0 ? kSizes[i][1] : view_.wish().height / 2 * 2);
        if (i > 0) ImGui::SameLine();
        ImGui::RadioButton(
            fmt::format("{}{}x{}", i == 0 ? "as here, " : "", size.x, size.y).c_str(),
            &choice_.size, static_cast<int>(i));
    }
    int webm = choice_.webm ? 1 : 0;
    ImGui::RadioButton("MP4 (H.264)", &webm, 0);
    ImGui::SameLine();
    ImGui::RadioButton("WebM (VP9)", &webm, 1);
    choice_.webm = webm == 1;
}

void Recorder::start() {
    try {
        take_ = std::make_unique<FilmTake>(window_.context(), view_, settings());
        startedAt_ = Clock::now();
    } catch (const InputError& error) {
        notices_.refuse(error.diagnostics());
    } catch (const MachineError& error) {
        Diagnostics why;
        why.error({settings().file}, error.what());
        notices_.refuse(why);
    }
    window_.wake();
}

void Recorder::finishStep() {
    if (!isRecording()) return;
    const FilmSettings settings = take_->settings();
    try {
        take_->step();
        if (!take_->written()) return;
        notices_.say(fmt::format("wrote {}: {} frames, {}x{}", settings.file,
                                 settings.plan.frames(), settings.width, settings.height));
    } catch (const InputError& error) {
        notices_.refuse(error.diagnostics());
    } catch (const MachineError& error) {
        Diagnostics why;
        why.error({settings.file}, error.what());
        notices_.refuse(why);
    }
    end();
}

void Recorder::cancel() {
    if (!isRecording() || take_->drawn()) return;
    notices_.say("the film is not recorded: nothing of it stays");
    end();
}

void Recorder::end() {
    take_.reset();
    view_.showTime();
    window_.wake();
}

void Recorder::show() {
    if (!isRecording()) return;
    const Stage::Wish& room = view_.wish();
    const FilmSettings& s = take_->settings();
    const float scale =
        std::min({1.0f, static_cast<float>(room.width) / static_cast<float>(s.width),
                  static_cast<float>(room.height) / static_cast<float>(s.height)});
    const int width = static_cast<int>(std::lround(static_cast<float>(s.width) * scale));
    const int height = static_cast<int>(std::lround(static_cast<float>(s.height) * scale));
    const PixelRectangle part{(room.width - width) / 2, (room.height - height) / 2, width, height};
    if (!take_->show(window_, part)) view_.show();
}

void Recorder::drawProgress(glm::vec2 pictureSize) {
    const int frames = take_->settings().plan.frames();
    const float done =
        static_cast<float>(take_->framesDone()) + (take_->drawn() ? 0.0f : take_->frameShare());
    const double passed = std::chrono::duration<double>(Clock::now() - startedAt_).count();
    std::string text = "finishing the film";
    if (!take_->drawn()) {
        text = fmt::format("frame {} of {}", take_->framesDone() + 1, frames);
        if (done >= 1)
            text += fmt::format(", {} left",
                                clockText(passed * (static_cast<double>(frames) - done) / done));
    }
    ImGui::SetNextWindowPos({pictureSize.x / 2, pictureSize.y - 48}, ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowSize({std::min(26 * ImGui::GetFontSize(), pictureSize.x), 0});
    ImGui::SetNextWindowBgAlpha(0.9f);
    ImGui::Begin("Recording", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    ImGui::TextColored(ImVec4(0.95f, 0.25f, 0.2f, 1), "REC");
    ImGui::SameLine();
    ImGui::Text("%s  %s", take_->settings().file.c_str(), text.c_str());
    ImGui::ProgressBar(done / static_cast<float>(frames), {-1, 0.5f * ImGui::GetFontSize()}, "");
    const bool stop = !take_->drawn() && ImGui::Button("Stop, and keep nothing (Esc)");
    ImGui::End();
    if (stop) cancel();
}

bool Recorder::takeKey(const KeyPress& press) {
    if (!isRecording()) return question_.takeKey(press);
    if (press.key == kKeyEscape) cancel();
    return true;
}

}  // namespace vitrine
