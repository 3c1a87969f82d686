// SPDX-License-Identifier: MIT
#include "app/viewer/leaving.hpp"

#include <imgui.h>

#include <filesystem>
#include <utility>

namespace vitrine {

void Leaving::ask(std::function<void()> leave) {
    leave_ = std::move(leave);
    if (recorder_.isRecording()) return film_.open();
    if (!view_.scene.edits.empty()) return changes_.open();
    std::exchange(leave_, {})();
}

void Leaving::draw(glm::vec2 /*pictureSize*/) {
    drawFilm();
    drawChanges();
}

bool Leaving::takeKey(const KeyPress& press) {
    return film_.takeKey(press) || changes_.takeKey(press);
}

void Leaving::drawFilm() {
    if (!film_.begin()) return;
    ImGui::TextUnformatted("If it is stopped, nothing of it stays.");
    const bool goesOn = mainButton("Go on recording") || film_.takeEnter();
    ImGui::SameLine();
    const bool stop = ImGui::Button("Stop it");
    if (goesOn || stop) film_.close();
    film_.end();
    if (!stop) return;
    recorder_.cancel();
    ask(std::exchange(leave_, {}));
}

void Leaving::drawChanges() {
    if (!changes_.begin()) return;
    const size_t values = view_.scene.edits.assignments().size();
    const std::string name = std::filesystem::path(view_.scene.file()).filename().string();
    ImGui::Text("%zu value%s of %s %s been changed.", values, values == 1 ? "" : "s", name.c_str(),
                values == 1 ? "has" : "have");
    if (!view_.scene.canSave())
        ImGui::TextDisabled(
            "This file keeps no changes. \"Save as\" in the menu File makes a scene.");
    ImGui::Spacing();
    const bool save = view_.scene.canSave() && (mainButton("Save them") || changes_.takeEnter());
    if (view_.scene.canSave()) ImGui::SameLine();
    const bool lose = ImGui::Button("Lose them");
    ImGui::SameLine();
    const bool stay = ImGui::Button("Cancel");
    if (save || lose || stay) changes_.close();
    changes_.end();
    if (save) notices_.say(view_.scene.save());
    if (lose || (save && view_.scene.edits.empty())) std::exchange(leave_, {})();
}

}  // namespace vitrine
