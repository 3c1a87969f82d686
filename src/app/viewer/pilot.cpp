// SPDX-License-Identifier: MIT
#include "app/viewer/pilot.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

namespace vitrine {
namespace {

constexpr float kWalkingSpeed = 1.6f;  // m/s
constexpr float kLongestStep = 0.1f;   // s: a slow picture must not make leaps

}  // namespace

glm::vec3 directionThrough(const Camera& camera, glm::vec2 cursor) {
    const CameraFrame f = frameOf(camera);
    const float height = heightAtUnitDistance(camera);
    return glm::normalize(height * (cursor.x * f.right + cursor.y * f.up) - f.back);
}

glm::vec2 Pilot::cursor(glm::vec2 pictureSize) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return glm::vec2(mouse.x - pictureSize.x / 2, pictureSize.y / 2 - mouse.y) /
           std::max(pictureSize.y, 1.0f);
}

void Pilot::flyTo(const Camera& goal, float seconds) {
    flight_ = Flight(camera, goal, seconds);
}

bool Pilot::steer(float elapsed, glm::vec2 pictureSize) {
    if (dragged(pictureSize) || walked(elapsed)) {
        flight_.stop();
        return true;
    }
    if (!flight_.active()) return false;
    camera = flight_.advance(std::min(elapsed, kLongestStep));
    return true;
}

bool Pilot::dragged(glm::vec2 pictureSize) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse) return false;
    bool moved = false;
    const glm::vec2 drag =
        glm::vec2(io.MouseDelta.x, -io.MouseDelta.y) / std::max(pictureSize.y, 1.0f);
    if (drag != glm::vec2(0)) {
        moved = true;
        const bool walking = ImGui::IsKeyDown(GLFW_KEY_W) || ImGui::IsKeyDown(GLFW_KEY_S) ||
                             ImGui::IsKeyDown(GLFW_KEY_A) || ImGui::IsKeyDown(GLFW_KEY_D);
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left))
            tumble(camera, drag);
        else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) && walking)
            lookAround(camera, drag);
        else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                 ImGui::IsMouseDown(ImGuiMouseButton_Middle))
            pan(camera, drag);
        else
            moved = false;
    }
    if (io.MouseWheel != 0) {
        dolly(camera, io.MouseWheel, cursor(pictureSize));
        moved = true;
    }
    return moved;
}

bool Pilot::walked(float elapsed) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyCtrl) return false;
    const auto down = [](int key) { return ImGui::IsKeyDown(key) ? 1.0f : 0.0f; };
    const glm::vec3 way(down(GLFW_KEY_D) - down(GLFW_KEY_A), down(GLFW_KEY_E) - down(GLFW_KEY_Q),
                        down(GLFW_KEY_W) - down(GLFW_KEY_S));
    if (way == glm::vec3(0)) return false;
    const float speed = kWalkingSpeed * (io.KeyShift ? 4.0f : 1.0f);
    walk(camera, way * std::min(elapsed, kLongestStep) * speed, false);
    return true;
}

}  // namespace vitrine
