// SPDX-License-Identifier: MIT
#include "app/viewer/dialogue.hpp"

#include <imgui.h>

#include <utility>

namespace vitrine {

void Dialogue::open() {
    wanted_ = true;
    closing_ = enter_ = false;
    window_.wake();
}

void Dialogue::askAgain() {
    freshFrames_ = kFreshFrames + 1;
    // An Enter that is still held would leave the field again.
    ImGui::GetIO().KeysDown[kKeyEnter] = ImGui::GetIO().KeysDown[kKeyKeypadEnter] = false;
    window_.wake();
}

void Dialogue::close() {
    wanted_ = false;
    closing_ = shown_;
    window_.wake();
}

bool Dialogue::begin() {
    if (std::exchange(wanted_, false)) {
        ImGui::OpenPopup(title_.c_str());
        shown_ = true;
        freshFrames_ = kFreshFrames + 1;
    }
    if (!shown_) return false;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    shown_ = ImGui::BeginPopupModal(title_.c_str(), nullptr,
                                    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
    if (!shown_) return false;
    // ImGui finds the size, and darkens what is behind, in the course of some frames.
    if (freshFrames_ > 0) {
        --freshFrames_;
        window_.wake();
    }
    if (std::exchange(closing_, false)) {
        ImGui::CloseCurrentPopup();
        shown_ = false;
    }
    return true;
}

void Dialogue::end() {
    ImGui::EndPopup();
}

bool Dialogue::takeKey(const KeyPress& press) {
    if (!isOpen()) return false;
    if (press.key == kKeyEscape) close();
    if (press.key == kKeyEnter || press.key == kKeyKeypadEnter) enter_ = true;
    return true;
}

bool Dialogue::takeEnter() {
    return std::exchange(enter_, false);
}

bool Dialogue::answer(const char* yes) {
    const bool pressed = mainButton(yes);
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) close();
    return takeEnter() || pressed;
}

void Dialogue::end(bool answered, bool good) {
    if (good)
        close();
    else if (answered)
        askAgain();
    end();
}

bool mainButton(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.78f, 0.52f, 0.12f, 1));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImVec4(0.90f, 0.62f, 0.18f, 1));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, ImVec4(0.66f, 0.43f, 0.08f, 1));
    const bool pressed = ImGui::Button(text);
    ImGui::PopStyleColor(3);
    return pressed;
}

}  // namespace vitrine
