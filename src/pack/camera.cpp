// SPDX-License-Identifier: MIT
#include "pack/camera.hpp"

#include <cmath>

namespace vitrine {

void packCamera(const Camera& camera, int width, int height, FrameBlock& block) {
    constexpr float kSensorWidth = 36;  // mm
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    const float halfHeight = camera.fov > 0 ? std::tan(glm::radians(camera.fov) / 2)
                                            : 0.5f * kSensorWidth / camera.focalLength / aspect;
    block.cameraEye = glm::vec4(camera.eye, 2 * halfHeight / static_cast<float>(height));
    block.cameraForward = glm::vec4(forward, 0);
    block.cameraRight = glm::vec4(right * halfHeight * aspect, 0);
    block.cameraUp = glm::vec4(up * halfHeight, 0);
    block.image.x = width;
    block.image.y = height;
}

}  // namespace vitrine
