// SPDX-License-Identifier: MIT
#include "app/viewer/camera_control.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr float kTurnsAHeight = 3.2f;             // radians for a drag over the picture's height
constexpr float kSteepest = glm::radians(89.0f);  // to the horizon
constexpr float kNearest = 1e-3f;                 // eye to target, m

/// The direction turned about the world's up and, limited, towards it.
glm::vec3 turned(glm::vec3 direction, glm::vec3 up, float yaw, float pitch) {
    const float length = glm::length(direction);
    up = glm::normalize(up);
    glm::vec3 d = glm::angleAxis(yaw, up) * (direction / length);
    const float elevation = std::asin(std::clamp(glm::dot(d, up), -1.0f, 1.0f));
    const float wanted = std::clamp(elevation + pitch, -kSteepest, kSteepest);
    const glm::vec3 level = d - glm::dot(d, up) * up;
    if (glm::length(level) < 1e-6f) return direction;
    d = std::cos(wanted) * glm::normalize(level) + std::sin(wanted) * up;
    return d * length;
}

float eased(float t) {
    return t * t * t * (t * (6 * t - 15) + 10);
}

glm::quat orientationOf(const Camera& camera) {
    const CameraFrame f = frameOf(camera);
    return glm::quat_cast(glm::mat3(f.right, f.up, f.back));
}

}  // namespace

CameraFrame frameOf(const Camera& camera) {
    const glm::vec3 back = glm::normalize(camera.eye - camera.target);
    const glm::vec3 right = glm::normalize(glm::cross(camera.up, back));
    return {right, glm::cross(back, right), back};
}

float heightAtUnitDistance(const Camera& camera, float aspect) {
    constexpr float kSensorWidth = 36;  // mm
    if (camera.fov > 0) return 2 * std::tan(glm::radians(camera.fov) / 2);
    const float focal = camera.focalLength > 0 ? camera.focalLength : Camera::kDefaultFocalLength;
    return kSensorWidth / focal / aspect;
}

void tumble(Camera& camera, glm::vec2 offset) {
    camera.eye = camera.target + turned(camera.eye - camera.target, camera.up,
                                        -offset.x * kTurnsAHeight, -offset.y * kTurnsAHeight);
}

void lookAround(Camera& camera, glm::vec2 offset, float height) {
    camera.target = camera.eye + turned(camera.target - camera.eye, camera.up, -offset.x * height,
                                        offset.y * height);
}

void pan(Camera& camera, glm::vec2 offset, float height) {
    const CameraFrame f = frameOf(camera);
    const float metres = height * glm::distance(camera.eye, camera.target);
    const glm::vec3 shift = -metres * (offset.x * f.right + offset.y * f.up);
    camera.eye += shift;
    camera.target += shift;
}

void dolly(Camera& camera, float steps, glm::vec2 cursor, float height) {
    const CameraFrame f = frameOf(camera);
    const float distance = glm::distance(camera.eye, camera.target);
    const float next = std::max(distance * std::pow(0.9f, steps), kNearest);
    // The point of the target's plane under the cursor does not move in the picture.
    const glm::vec3 aside = height * (distance - next) * (cursor.x * f.right + cursor.y * f.up);
    camera.target += aside;
    camera.eye = camera.target + next * f.back;
}

void walk(Camera& camera, glm::vec3 metres, bool flying) {
    const glm::vec3 up = glm::normalize(camera.up);
    const CameraFrame f = frameOf(camera);
    const glm::vec3 forward = flying ? -f.back : glm::normalize(glm::cross(up, f.right));
    const glm::vec3 shift = metres.x * f.right + metres.y * up + metres.z * forward;
    camera.eye += shift;
    camera.target += shift;
}

Flight::Flight(const Camera& from, const Camera& to, float seconds)
    : from_(from), to_(to), duration_(seconds) {
    worldFromCamera_[0] = orientationOf(from);
    worldFromCamera_[1] = orientationOf(to);
}

void Flight::bendThrough(glm::vec3 point) {
    // A quadratic curve passes `point` at its middle if it is drawn towards this much more.
    bend_ = 2.0f * (point - 0.5f * (from_.eye + to_.eye));
}

void Flight::setGoal(const Camera& to) {
    to_ = to;
    worldFromCamera_[1] = orientationOf(to);
}

glm::vec3 Flight::eyeAt(float share) const {
    return glm::mix(from_.eye, to_.eye, share) + 2 * share * (1 - share) * bend_;
}

Camera Flight::advance(float seconds) {
    passed_ += seconds;
    if (passed_ >= duration_) {
        duration_ = 0;
        return to_;
    }
    const float share = eased(passed_ / duration_);
    const glm::mat3 frame =
        glm::mat3_cast(glm::slerp(worldFromCamera_[0], worldFromCamera_[1], share));
    Camera camera = to_;
    camera.eye = eyeAt(share);
    const float distance =
        glm::mix(glm::distance(from_.eye, from_.target), glm::distance(to_.eye, to_.target), share);
    camera.target = camera.eye - distance * frame[2];
    camera.up = frame[1];
    return camera;
}

Camera lookingAt(const Camera& camera, glm::vec3 point, float radius, float height) {
    Camera result = camera;
    glm::vec3 back = camera.eye - point;
    if (glm::length(back) < 1e-4f) back = camera.eye - camera.target;
    const float distance = std::max(radius, kNearest) / (0.32f * height);
    result.target = point;
    result.eye = point + distance * glm::normalize(back);
    return result;
}

}  // namespace vitrine
