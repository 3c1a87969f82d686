// SPDX-License-Identifier: MIT
#include "app/viewer/handles.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/session/bare_file.hpp"

namespace vitrine {
namespace {

constexpr float kHandSlip = 40;  // ImGui units between two looks at the mouse

struct Mode {
    HandleMode mode;
    const char *name, *key, *option, *animated;
};
constexpr std::array<Mode, 3> kModes{{
    {HandleMode::kMove, "Move", "M", "at", "an animation moves it"},
    {HandleMode::kTurn, "Turn", "R", "rotate", "an animation turns it"},
    {HandleMode::kScale, "Scale", "T", "scale", "an animation scales it"},
}};

const Mode& modeOf(HandleMode mode) {
    return kModes[static_cast<size_t>(mode)];
}

/// A pixel at the usual size of text.
float unitOf() {
    return ImGui::GetFontSize() / 13;
}

std::string listText(glm::vec3 v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

}  // namespace

std::string whyFixed(const Scene& scene, size_t node, HandleMode mode) {
    if (scene.nodes[node].name.empty()) return "it has no name in the file";
    const Mode& m = modeOf(mode);
    for (const AnimationTrack& track : scene.animations) {
        if (track.target.object != AnimationTarget::Object::kNode || track.target.index != node)
            continue;
        if (track.target.key == m.option ||
            (mode == HandleMode::kTurn && track.target.key == kOrientationKey))
            return m.animated;
    }
    return "";
}

Place placeOf(const Node& node) {
    Place place{node.at, node.rotate, node.scale};
    if (node.orientation) {
        const glm::vec3 angles = anglesOf(glm::mat3_cast(*node.orientation), glm::vec3(0));
        place.rotate = {tidy(angles.x, 1e-3f), tidy(angles.y, 1e-3f), tidy(angles.z, 1e-3f)};
    }
    return place;
}

void Handles::addCommands(std::vector<Command>& list) {
    for (const Mode& m : kModes)
        list.push_back({"Edit", fmt::format("{} by handles", m.name), m.key, m.key[0], false, false,
                        [this, mode = m.mode] { mode_ = mode; }, mode_ == m.mode});
    list.push_back(
        {"Edit", "Select what it hangs on", "U", 'U', false, false, [this] { selectParent(); }});
}

std::optional<size_t> Handles::selected() const {
    const int node = view_.selection.node;
    if (node < 0 || static_cast<size_t>(node) >= view_.scene.loaded().scene.nodes.size()) return {};
    return static_cast<size_t>(node);
}

void Handles::selectParent() {
    const auto node = selected();
    if (!node) return;
    const auto parent = NodeTree(view_.scene.loaded().scene).parent(*node);
    if (parent) view_.selection = {static_cast<int>(*parent), true};
}

void Handles::draw(glm::vec2 pictureSize) {
    const auto node = selected();
    // The buttons learn their size when they are drawn first.
    if (view_.selection.node != shownFor_) window_.wake();
    shownFor_ = view_.selection.node;
    const Scene& scene = view_.scene.loaded().scene;
    const Scene& posed = view_.scene.posed();
    if (!node || posed.nodes.size() != scene.nodes.size() ||
        (drag_ && path_ != "node." + scene.nodes[*node].name))
        endDrag();
    if (!node || posed.nodes.size() != scene.nodes.size()) return hover_.reset();

    const Projection projection(view_.pilot.camera, pictureSize);
    const NodeTree tree(scene);
    const std::vector<glm::mat4> world = worldFromNodes(posed);
    const auto parent = tree.parent(*node);
    const glm::mat4 worldFromParent = parent ? world[*parent] : glm::mat4(1);
    if (drag_) pull(projection);
    // As it is now, with what an animation has made of it.
    const Place place = drag_ ? shown_ : placeOf(posed.nodes[*node]);
    const HandleView handles(mode_, place, worldFromParent, projection, unitOf());
    const std::string why = whyFixed(scene, *node, mode_);

    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({0, 0}, {pictureSize.x, pictureSize.y});
    drawBox(list, projection, tree, *node, world[*node]);
    if (!drag_ && why.empty()) hover(handles, projection, *node, worldFromParent);
    if (!why.empty()) hover_.reset();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (drag_)
        handles.drawDrag(list, *drag_, {mouse.x, mouse.y});
    else
        handles.draw(list, hover_ ? std::optional(hover_->handle) : std::nullopt, !why.empty());
    list.PopClipRect();
    // Over a handle that is not held, wheel and right button are the camera's.
    if (drag_ || letGo_) ImGui::GetIO().WantCaptureMouse = true;
    if (drag_ || hover_) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!view_.scene.problems().hasErrors()) drawButtons(why);
    if (drag_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) endDrag();
    letGo_ = letGo_ && ImGui::IsAnyMouseDown();
}

void Handles::drawButtons(const std::string& why) {
    const float unit = unitOf();
    ImGui::SetNextWindowPos({8 * unit, 8 * unit});
    ImGui::SetNextWindowBgAlpha(0.72f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(4 * unit, 4 * unit));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 4 * unit);
    ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, 3 * unit);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(3 * unit, 3 * unit));
    ImGui::Begin("Handles", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_AlwaysAutoResize);
    for (const Mode& m : kModes) {
        const bool chosen = m.mode == mode_;
        const ImVec4 plain(1, 1, 1, 0.08f), bright(1.0f, 0.82f, 0.36f, 1);
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? bright : plain);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, chosen ? bright : ImVec4(1, 1, 1, 0.2f));
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, bright);
        ImGui::PushStyleColor(ImGuiCol_Text,
                              chosen ? ImVec4(0.1f, 0.1f, 0.1f, 1) : ImVec4(1, 1, 1, 0.9f));
        if (m.mode != HandleMode::kMove) ImGui::SameLine();
        if (ImGui::Button(m.name)) mode_ = m.mode;
        ImGui::PopStyleColor(4);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("key %s; with Ctrl in steps", m.key);
    }
    if (!why.empty()) ImGui::TextDisabled("%s", why.c_str());
    ImGui::End();
    ImGui::PopStyleVar(5);
}

void Handles::drawBox(ImDrawList& list, const Projection& projection, const NodeTree& tree,
                      size_t node, const glm::mat4& worldFromNode) const {
    // Of a group, a box in its own frame around all that hangs on it.
    const glm::mat4 nodeFromWorld = glm::inverse(worldFromNode);
    Aabb whole;
    for (const PackedInstance& instance : view_.moment().instances) {
        if (!tree.isWithin(instance.node, node)) continue;
        if (instance.node == node)
            return drawSelectionBox(list, projection, instance.objectBox, instance.worldFromObject,
                                    unitOf());
        whole.grow(instance.objectBox.transformed(nodeFromWorld * instance.worldFromObject));
    }
    if (isFinite(whole.extent()))
        drawSelectionBox(list, projection, whole, worldFromNode, unitOf());
}

void Handles::hover(const HandleView& handles, const Projection& projection, size_t node,
                    const glm::mat4& worldFromParent) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || !ImGui::IsMousePosValid()) return hover_.reset();
    const glm::vec2 mouse(io.MousePos.x, io.MousePos.y);
    const bool clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool pressed = ImGui::IsMouseDown(ImGuiMouseButton_Left) ||
                         ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                         ImGui::IsMouseDown(ImGuiMouseButton_Middle);
    if (pressed && !clicked) return hover_.reset();  // the camera is being dragged
    const auto handle = handles.at(mouse);
    const bool slipped =
        clicked && hover_ && glm::distance(mouse, hover_->mouse) < kHandSlip * unitOf();
    // Where it was seen last is where it was grabbed, if the mouse has gone on since.
    if (handle && !(slipped && *handle == hover_->handle))
        hover_ = Hover{*handle, projection.through(mouse), mouse};
    else if (!handle && !slipped)
        hover_.reset();
    if (!clicked || !hover_) return;
    const Node& grabbed = view_.scene.loaded().scene.nodes[node];
    shown_ = placeOf(grabbed);
    drag_.emplace(HandleDrag::Setting{mode_, hover_->handle, shown_, worldFromParent,
                                      handles.reach(), handles.pixel(), projection.frame()},
                  hover_->sight);
    path_ = "node." + grabbed.name;
    gesture_ = view_.scene.edits.newGesture();
    sent_ = false;
}

void Handles::pull(const Projection& projection) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) || ImGui::IsKeyPressed(kKeyEscape, false))
        return cancel();
    // Who lets go of both at once has not meant to leave the steps.
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) snaps_ = io.KeyCtrl;
    const Place place = drag_->to(projection.through({io.MousePos.x, io.MousePos.y}), snaps_);
    if (place == shown_) return;
    shown_ = place;
    // What stands in no scene file is read anew, which takes too long to follow the hand.
    if (!isBareFile(view_.scene.file())) send(place);
}

void Handles::send(const Place& place) {
    const glm::vec3 value = drag_->setting().mode == HandleMode::kMove   ? place.at
                            : drag_->setting().mode == HandleMode::kTurn ? place.rotate
                                                                         : place.scale;
    const bool even =
        drag_->setting().mode == HandleMode::kScale && value.x == value.y && value.y == value.z;
    view_.scene.edits.set(path_ + '.' + modeOf(drag_->setting().mode).option,
                          even ? fmt::format("{}", value.x) : listText(value), gesture_);
    sent_ = true;
}

void Handles::endDrag() {
    if (!drag_) return;
    if (!sent_ && shown_ != drag_->setting().place) send(shown_);
    drag_.reset();
    hover_.reset();
}

void Handles::cancel() {
    if (sent_) view_.scene.edits.undo();
    letGo_ = true;
    drag_.reset();
    hover_.reset();
}

}  // namespace vitrine
