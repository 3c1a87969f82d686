// SPDX-License-Identifier: MIT
#include "app/viewer/overlay.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <sstream>

#include "base/file.hpp"
#include "gpu/interface_look.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxSourceBytes = 16u << 20;
constexpr size_t kMostProblems = 12;
constexpr ImGuiWindowFlags kLabel = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

}  // namespace

std::string sourceLine(const std::string& file, int line) {
    try {
        std::istringstream text(readFile(file, kMaxSourceBytes));
        std::string result;
        for (int i = 0; i < line; ++i)
            if (!std::getline(text, result)) return "";
        return result;
    } catch (const InputError&) {
        return "";
    }
}

void drawProblems(const Diagnostics& problems, const char* outlook, glm::vec2 pictureSize) {
    if (!problems.hasErrors()) return;
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.32f, 0.05f, 0.05f, 0.92f));
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({pictureSize.x, 0});
    ImGui::Begin("Problems", nullptr, kLabel);
    ImGui::PushTextWrapPos(0);
    size_t shown = 0;
    for (const Diagnostic& problem : problems.list()) {
        if (problem.severity != Severity::kError) continue;
        if (++shown > kMostProblems) break;
        ImGui::Text("%s: %s", problem.where.text().c_str(), problem.message.c_str());
        const std::string line = sourceLine(problem.where.file, problem.where.line);
        if (line.empty()) continue;
        ImGui::PushFont(sourceFont());
        ImGui::TextColored(ImVec4(1, 0.85f, 0.6f, 1), "%5d | %s", problem.where.line, line.c_str());
        ImGui::PopFont();
    }
    ImGui::TextDisabled("%s", outlook);
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleColor();
}

void drawFacts(const Facts& facts, glm::vec2 pictureSize) {
    if (facts.empty()) return;
    ImGui::SetNextWindowPos({8, pictureSize.y - 48}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("Under the cursor", nullptr,
                 kLabel | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    if (ImGui::BeginTable("facts", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& [name, value] : facts) {
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", name.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(value.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void drawMessage(const std::string& text, glm::vec2 pictureSize) {
    ImGui::SetNextWindowPos({pictureSize.x / 2, pictureSize.y - 48}, ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("Message", nullptr,
                 kLabel | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    // A window that fits its text gives it no width to wrap at.
    const float room = pictureSize.x - 4 * ImGui::GetFontSize();
    ImGui::PushTextWrapPos(std::min(ImGui::CalcTextSize(text.c_str()).x + 1, room) +
                           ImGui::GetCursorPosX());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void drawProgress(const std::string& text, glm::vec2 pictureSize) {
    ImGui::SetNextWindowPos({pictureSize.x - 8, pictureSize.y - 48}, ImGuiCond_Always, {1, 1});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("Progress", nullptr,
                 kLabel | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    ImGui::TextUnformatted((text + " ...").c_str());
    ImGui::End();
}

TimelineTouch drawTimeline(Timeline& timeline, glm::vec2 pictureSize) {
    ImGui::SetNextWindowPos({0, pictureSize.y}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({pictureSize.x, 0});
    ImGui::SetNextWindowBgAlpha(0.7f);
    ImGui::Begin("Timeline", nullptr, kLabel);
    TimelineTouch touch;
    touch.played = ImGui::Button(timeline.playing ? "pause" : "play");
    ImGui::SameLine();
    ImGui::Checkbox("loop", &timeline.loop);
    ImGui::SameLine();
    touch.record = ImGui::Button("record");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    touch.moved = ImGui::SliderFloat("##time", &timeline.time, 0, timeline.duration, "%.2f s");
    ImGui::End();
    return touch;
}

}  // namespace vitrine
