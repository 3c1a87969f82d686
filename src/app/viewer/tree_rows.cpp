// SPDX-License-Identifier: MIT
#include "app/viewer/tree_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr float kMostRows = 8, kLeastRows = 3;  // seen at once

/// An eye, closed if nobody sees the node; pale if that is not its own doing.
bool drawEye(bool open, bool pale) {
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton("eye", {1.5f * size, size});
    const float alpha = ImGui::IsItemHovered() ? 1.0f : pale ? 0.25f : open ? 0.75f : 0.45f;
    const ImU32 color = ImGui::GetColorU32(ImVec4(1, 1, 1, alpha));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip(open ? "hide it" : "show it");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 middle(corner.x + 0.65f * size, corner.y + 0.52f * size);
    const float half = 0.5f * size, width = std::max(1.0f, size / 11);
    const ImVec2 left(middle.x - half, middle.y), right(middle.x + half, middle.y);
    const auto lid = [&](float height) {
        list.AddBezierQuadratic(left, {middle.x, middle.y + 2 * height * size}, right, color,
                                width);
    };
    lid(0.30f);
    if (open) {
        lid(-0.30f);
        list.AddCircleFilled(middle, 0.16f * size, color);
    } else {  // lashes
        for (const float x : {-0.28f, 0.0f, 0.28f})
            list.AddLine(
                {middle.x + x * size, middle.y + (0.30f - std::abs(x) * 0.5f) * size},
                {middle.x + 1.35f * x * size, middle.y + (0.50f - std::abs(x) * 0.5f) * size},
                color, width);
    }
    return clicked;
}

class Rows {
  public:
    Rows(const Scene& scene, Edits& edits, Selection& selection)
        : scene_(scene),
          edits_(edits),
          selection_(selection),
          tree_(scene),
          visible_(visibleNodes(scene)) {}

    void draw() {
        for (const size_t node : tree_.roots()) draw(node);
    }

  private:
    void draw(size_t node) {
        const Node& n = scene_.nodes[node];
        const bool leaf = tree_.children(node).empty();
        const bool selected = selection_.node == static_cast<int>(node);
        const bool scroll = selected && selection_.justMade;
        ImGui::PushID(static_cast<int>(node));
        if (drawEye(visible_[node], n.visible && !visible_[node])) toggle(n);
        ImGui::SameLine(0, 0);
        // The eyes stand in one column, the names are indented.
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + depth_ * ImGui::GetTextLineHeight());
        if (!visible_[node])
            ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        const std::string name = n.name.empty() ? "(no name)" : shortName(scene_, tree_, node);
        if (!leaf && !selected && leadsToSelection(node)) ImGui::SetNextItemOpen(true);
        const bool open = ImGui::TreeNodeEx(
            "node",
            ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_OpenOnArrow |
                ImGuiTreeNodeFlags_NoTreePushOnOpen | (leaf ? ImGuiTreeNodeFlags_Leaf : 0) |
                (selected ? ImGuiTreeNodeFlags_Selected : 0),
            "%s", name.c_str());
        if (!visible_[node]) ImGui::PopStyleColor();
        if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen())
            selection_ = {static_cast<int>(node), false, false};
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
            selection_ = {static_cast<int>(node), false, true};
        if (scroll) ImGui::SetScrollHereY();
        ImGui::PopID();
        if (!open || leaf) return;
        ++depth_;
        for (const size_t child : tree_.children(node)) draw(child);
        --depth_;
    }

    /// To one that has just been made.
    [[nodiscard]] bool leadsToSelection(size_t node) const {
        return selection_.justMade && selection_.node >= 0 &&
               static_cast<size_t>(selection_.node) < scene_.nodes.size() &&
               tree_.isWithin(static_cast<size_t>(selection_.node), node);
    }

    void toggle(const Node& node) {
        if (node.name.empty()) return;
        const std::string key = "node." + node.name + ".visible";
        if (edits_.has(key))
            edits_.reset(key);  // back to what the file says
        else
            edits_.set(key, node.visible ? "false" : "true");
    }

    const Scene& scene_;
    Edits& edits_;
    Selection& selection_;
    NodeTree tree_;
    std::vector<bool> visible_;
    float depth_ = 0;
};

}  // namespace

void ObjectTree::draw(const Scene& scene, Edits& edits, Selection& selection) {
    const float row = ImGui::GetTextLineHeightWithSpacing();
    if (ImGui::BeginChild("objects", {0, std::clamp(height_, kLeastRows * row, kMostRows * row)})) {
        Rows(scene, edits, selection).draw();
        height_ = ImGui::GetCursorPosY();
    }
    ImGui::EndChild();
}

}  // namespace vitrine
