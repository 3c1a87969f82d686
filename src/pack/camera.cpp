// SPDX-License-Identifier: MIT
#include "pack/camera.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {

void packCamera(const Camera& camera, int width, int height, FrameBlock& block) {
    constexpr float kSensorWidth = 36;      // mm
    constexpr float kNearestFocus = 1e-3f;  // m
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    const float halfHeight = camera.fov > 0 ? std::tan(glm::radians(camera.fov) / 2)
                                            : 0.5f * kSensorWidth / camera.focalLength / aspect;
    const float halfWidth = halfHeight * aspect;
    block.cameraEye = glm::vec4(camera.eye, 2 * halfHeight / static_cast<float>(height));
    block.cameraForward = glm::vec4(forward, 0);
    block.cameraRight = glm::vec4(right * halfWidth, halfWidth * halfWidth);
    block.cameraUp = glm::vec4(up * halfHeight, halfHeight * halfHeight);
    // 18 mm, half of the sensor, over the half width at distance 1 is the focal length.
    const float focalLength = 0.5e-3f * kSensorWidth / halfWidth;
    const float focus =
        camera.focusDistance > 0 ? camera.focusDistance : glm::length(camera.target - camera.eye);
    block.lens = glm::vec4(camera.fStop > 0 ? focalLength / (2 * camera.fStop) : 0.0f,
                           std::max(focus, kNearestFocus),
                           camera.apertureBlades >= 3 ? camera.apertureBlades : 0, 0);
    block.image.x = width;
    block.image.y = height;
}

glm::mat4 packProjection(const FrameBlock& block) {
    const glm::vec3 eye(block.cameraEye), forward(block.cameraForward);
    // Rows that give the coordinates on the image plane, from -1 to 1 over the picture.
    const glm::vec3 right(block.cameraRight), up(block.cameraUp);
    const glm::vec3 x = right / glm::dot(right, right), y = up / glm::dot(up, up);
    const glm::vec2 shift =
        2.0f * glm::vec2(block.jitter) / glm::vec2(block.image.x, block.image.y);
    const glm::vec3 rowX = x - shift.x * forward;
    const glm::vec3 rowY = y - shift.y * forward;
    return glm::transpose(glm::mat4(
        glm::vec4(rowX, -glm::dot(rowX, eye)), glm::vec4(rowY, -glm::dot(rowY, eye)),
        glm::vec4(0, 0, 0, VITRINE_NEAR_PLANE), glm::vec4(forward, -glm::dot(forward, eye))));
}

glm::vec2 sampleOffset(int index, int count) {
    if (count <= 1) return glm::vec2(0);
    // The R2 sequence (Roberts 2018), warped to a tent.
    const glm::vec2 r2 = glm::fract(glm::vec2(0.5f) + static_cast<float>(index) *
                                                          glm::vec2(0.7548776662f, 0.5698402910f));
    const glm::vec2 u = 2.0f * r2 - 1.0f;
    return glm::sign(u) * (1.0f - glm::sqrt(1.0f - glm::abs(u)));
}

}  // namespace vitrine
