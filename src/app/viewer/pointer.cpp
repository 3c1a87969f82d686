// SPDX-License-Identifier: MIT
#include "app/viewer/pointer.hpp"

#include <imgui.h>

#include <cmath>

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
                    [this] { view_.pilot.goHome(kFlightSeconds); }});
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
    const std::string& name = moment.instances[hit.x].name;
    const std::vector<Node>& nodes = view_.scene.loaded().scene.nodes;
    for (size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].name == name) view_.selection = {static_cast<int>(i), true};
}

void Pointer::flyToCursor() {
    if (ImGui::GetIO().WantCaptureMouse) return;
    const glm::uvec4 hit = view_.pick();
    if (!record::isSurface(hit)) return;
    const float distance = record::recordDistance(hit);
    const float height = view_.viewHeight();
    const Camera& camera = view_.pilot.camera;
    const glm::vec3 point = camera.eye + distance * view_.cursorDirection();
    // A third of the way remains: near enough to see it, far enough to see where it is.
    const float radius = 0.1f * distance * height;
    view_.pilot.flyTo(lookingAt(camera, point, radius, height), kFlightSeconds);
}

}  // namespace vitrine
