// SPDX-License-Identifier: MIT
#include "app/viewer/pointer.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "app/viewer/node_tree.hpp"
#include "app/viewer/way_round.hpp"
#include "pack/hit_record.hpp"

namespace vitrine {
namespace {

constexpr float kFlightSeconds = 0.7f;
constexpr float kClickDistance = 3;  // ImGui units; a mouse that moves farther drags

}  // namespace

void Pointer::addCommands(std::vector<Command>& list) {
    list.push_back({"Move", "Fly to what is under the cursor", "F", 'F', false, false,
                    [this] { flyToCursor(); }});
    list.push_back({"Move", "Where the camera was", "Home", kKeyHome, false, false,
                    [this] { view_.goHome(); }});
    const std::vector<Camera>& cameras = view_.scene.loaded().scene.cameras;
    for (size_t i = 0; i < cameras.size(); ++i) {
        const bool key = i < 9;
        const std::string digit = key ? std::to_string(i + 1) : "";
        list.push_back({"Move", "Camera " + cameras[i].name, digit,
                        key ? '1' + static_cast<int>(i) : 0, false, false,
                        [this, i] { view_.takeCamera(i); }});
    }
}

void Pointer::update() {
    const ImGuiIO& io = ImGui::GetIO();
    if (std::exchange(view_.selection.visited, false)) flyToSelection();
    if (io.WantCaptureMouse) return;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return flyToCursor();
    const ImVec2 way = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0);
    const bool still = std::abs(way.x) + std::abs(way.y) < kClickDistance;
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && still) select();
}

void Pointer::select() {
    view_.selection = {-1, false};
    const glm::uvec4 hit = view_.pick();
    const PackedMoment& moment = view_.moment();
    if (!record::isSurface(hit) || hit.x >= moment.instances.size()) return;
    view_.selection = {static_cast<int>(moment.instances[hit.x].node), true};
}

void Pointer::flyToCursor() {
    if (ImGui::GetIO().WantCaptureMouse) return;
    const glm::uvec4 hit = view_.pick();
    if (!record::isSurface(hit)) return;
    if (hit.x < view_.moment().instances.size() && flyToScreen(view_.moment().instances[hit.x]))
        return;
    const float distance = record::recordDistance(hit);
    const float height = view_.viewHeight();
    const Camera& camera = view_.pilot.camera;
    const glm::vec3 point = camera.eye + distance * view_.cursorDirection();
    // A third of the way remains: near enough to see it, far enough to see where it is.
    const float radius = 0.1f * distance * height;
    view_.pilot.flyTo(lookingAt(camera, point, radius, height), kFlightSeconds);
}

void Pointer::flyToSelection() {
    const std::vector<Node>& nodes = view_.scene.loaded().scene.nodes;
    const int selected = view_.selection.node;
    if (selected < 0 || static_cast<size_t>(selected) >= nodes.size()) return;
    const auto node = static_cast<size_t>(selected);
    const NodeTree tree(view_.scene.loaded().scene);
    Aabb box;
    for (const PackedInstance& instance : view_.moment().instances) {
        if (instance.node == node && flyToScreen(instance)) return;
        if (tree.isWithin(instance.node, node)) box.grow(instance.worldBox);
    }
    if (box.empty()) return;
    const float radius = 0.5f * glm::length(box.extent());
    view_.pilot.flyTo(
        lookingAt(view_.pilot.camera, box.centre(), 0.7f * radius, view_.viewHeight()),
        kFlightSeconds);
}

bool Pointer::flyToScreen(const PackedInstance& instance) {
    const Camera& camera = view_.pilot.camera;
    const auto screen = screenOf(instance.objectBox, instance.worldFromObject, camera.eye);
    if (!screen) return false;
    const glm::vec2 size = view_.pictureSize();
    const Camera goal = squareInFront(camera, *screen, size.x / std::max(size.y, 1.0f));
    if (!isSeen(*screen, goal, std::ref(surroundings_))) return false;
    view_.pilot.flyTo(goal, kFlightSeconds);
    return true;
}

}  // namespace vitrine
