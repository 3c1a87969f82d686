// SPDX-License-Identifier: MIT
#include "app/viewer/split.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr float kGrip = 8;      // ImGui units that a hand finds
constexpr float kEdge = 0.02f;  // the line stays this share of the width inside

}  // namespace

void Split::open(View view, bool plain) {
    open_ = true;
    plain_ = plain;
    view_ = view;
    if (stage_ != nullptr && stage_->canShow(view)) shown_ = view;
}

void Split::close() {
    open_ = false;
    shown_.reset();
    stage_.reset();
}

void Split::setFrame(std::shared_ptr<SceneFrame> frame) {
    if (!open_) return;
    if (stage_ == nullptr) stage_ = std::make_unique<Stage>();
    stage_->setFrame(std::move(frame));
    if (stage_->canShow(view_))
        shown_ = view_;
    else if (shown_ && !stage_->canShow(*shown_))
        shown_.reset();
}

bool Split::covers(const PackedMoment& moment) const {
    return stage_ == nullptr || stage_->covers(moment);
}

void Split::update(const PackedMoment& moment) {
    if (stage_ != nullptr) stage_->update(moment);
}

void Split::draw(Stage::Wish wish, double budgetSeconds) {
    if (stage_ == nullptr || !shown_) return;
    wish.view = *shown_;
    stage_->draw(wish, budgetSeconds);
}

int Split::columnOf(float line, int width) {
    return static_cast<int>(std::lround(line * static_cast<float>(width)));
}

void Split::join(ImageRgba8& left, const ImageRgba8& right, float line) {
    const auto skipped = static_cast<size_t>(columnOf(line, left.width)) * ImageRgba8::kChannels;
    for (int y = 0; y < left.height; ++y) {
        const auto row = right.row(y).subspan(skipped);
        std::copy(row.begin(), row.end(), left.row(y).subspan(skipped).begin());
    }
}

void Split::putInto(ImageRgba8& picture) {
    if (stage_ != nullptr && shown_) join(picture, stage_->image(), line_);
}

void Split::show(Window& window, int width, int height) const {
    if (stage_ == nullptr || !shown_ || stage_->picture() == nullptr) return;
    const int left = columnOf(line_, width);
    window.show(*stage_->picture(), {0, 0, width, height}, {left, 0, width - left, height});
}

void Split::drawLine(glm::vec2 pictureSize, const std::string& leftName,
                     const std::string& rightName) {
    if (stage_ == nullptr || !shown_) return;
    const float x = std::round(line_ * pictureSize.x);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::SetNextWindowPos({x - kGrip / 2, 0});
    ImGui::SetNextWindowSize({kGrip, pictureSize.y});
    ImGui::Begin("Split line", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    ImGui::InvisibleButton("line", {kGrip, pictureSize.y});
    const bool touched = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (touched) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive())
        line_ = std::clamp(ImGui::GetIO().MousePos.x / pictureSize.x, kEdge, 1 - kEdge);
    ImGui::End();
    ImGui::PopStyleVar();
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const ImU32 color = touched ? IM_COL32(255, 199, 92, 255) : IM_COL32(255, 255, 255, 200);
    list->AddLine({x, 0}, {x, pictureSize.y}, color, touched ? 3.0f : 1.5f);
    // The names on both sides, on dark so that they can be read over any picture.
    const auto name = [&](const std::string& text, float left) {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        list->AddRectFilled({left - 4, 6}, {left + size.x + 4, 12 + size.y},
                            IM_COL32(0, 0, 0, 150));
        list->AddText({left, 9}, IM_COL32(255, 255, 255, 255), text.c_str());
    };
    name(leftName, x - 12 - ImGui::CalcTextSize(leftName.c_str()).x);
    name(rightName, x + 12);
}

}  // namespace vitrine
