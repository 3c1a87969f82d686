// SPDX-License-Identifier: MIT
#include "app/viewer/pilot.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace vitrine {
namespace {

constexpr float kWalkingSpeed = 1.6f;  // m/s
constexpr float kLongestStep = 0.1f;   // s: a slow picture must not make leaps

}  // namespace

glm::vec3 directionThrough(const Camera& camera, glm::vec2 cursor, float height) {
    const CameraFrame f = frameOf(camera);
    return glm::normalize(height * (cursor.x * f.right + cursor.y * f.up) - f.back);
}

glm::vec2 Pilot::cursor(glm::vec2 pictureSize) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return glm::vec2(mouse.x - pictureSize.x / 2, pictureSize.y / 2 - mouse.y) /
           std::max(pictureSize.y, 1.0f);
}

float Pilot::viewHeight(glm::vec2 pictureSize) const {
    return heightAtUnitDistance(camera, pictureSize.x / std::max(pictureSize.y, 1.0f));
}

void Pilot::flyTo(const Camera& goal, float seconds) {
    held_ = true;
    if (seconds <= 0)
        camera = goal;
    else
        depart(goal, seconds);
}

void Pilot::depart(const Camera& goal, float seconds) {
    flight_ = Flight(camera, goal, seconds);
    if (!detour) return;
    if (const auto point = detour(camera, goal)) flight_.bendThrough(*point);
}

void Pilot::take(const Camera& sceneCamera, float seconds) {
    followed_ = sceneCamera;
    flyTo(sceneCamera, seconds);
    held_ = false;
}

void Pilot::follow(const Camera& sceneCamera, bool edited) {
    const bool moved = sceneCamera.eye != followed_.eye || sceneCamera.target != followed_.target ||
                       sceneCamera.up != followed_.up;
    const Camera before = std::exchange(camera, sceneCamera);
    followed_ = sceneCamera;
    if (moved && !edited && !held_ && flight_.active()) {
        flight_.setGoal(sceneCamera);  // on the way to a camera that goes on
    } else if (moved && (edited || !held_)) {
        flight_.stop();
        held_ = false;
        return;
    }
    camera.eye = before.eye;
    camera.target = before.target;
    camera.up = before.up;
}

bool Pilot::steer(float elapsed, glm::vec2 pictureSize) {
    if (dragged(pictureSize) || walked(elapsed)) {
        flight_.stop();
        held_ = true;
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
    const float height = viewHeight(pictureSize);
    const glm::vec2 drag =
        glm::vec2(io.MouseDelta.x, -io.MouseDelta.y) / std::max(pictureSize.y, 1.0f);
    if (drag != glm::vec2(0)) {
        moved = true;
        const bool walking = ImGui::IsKeyDown('W') || ImGui::IsKeyDown('S') ||
                             ImGui::IsKeyDown('A') || ImGui::IsKeyDown('D');
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left))
            tumble(camera, drag);
        else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) && walking)
            lookAround(camera, drag, height);
        else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                 ImGui::IsMouseDown(ImGuiMouseButton_Middle))
            pan(camera, drag, height);
        else
            moved = false;
    }
    if (io.MouseWheel != 0) {
        dolly(camera, io.MouseWheel, cursor(pictureSize), height);
        moved = true;
    }
    return moved;
}

bool Pilot::walked(float elapsed) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto down = [](int key) { return ImGui::IsKeyDown(key) ? 1.0f : 0.0f; };
    const glm::vec3 way(down('D') - down('A'), down('E') - down('Q'), down('W') - down('S'));
    // Who lets go of Ctrl before the S of Ctrl+S does not want to walk.
    if (way == glm::vec3(0)) meantOtherwise_ = walking_ = false;
    const bool otherwise = io.WantTextInput || io.WantCaptureKeyboard || io.KeyCtrl;
    if (!walking_) meantOtherwise_ = meantOtherwise_ || otherwise;
    if (meantOtherwise_ || otherwise) return false;
    walking_ = way != glm::vec3(0);
    const float seconds = std::min(elapsed, kLongestStep);
    const glm::vec3 metres = way * seconds * kWalkingSpeed * (io.KeyShift ? 4.0f : 1.0f);
    if (legs) return legs(camera, metres, seconds);
    if (way == glm::vec3(0)) return false;
    walk(camera, metres, true);
    return true;
}

}  // namespace vitrine
