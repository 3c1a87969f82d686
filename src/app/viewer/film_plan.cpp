// SPDX-License-Identifier: MIT
#include "app/viewer/film_plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

namespace vitrine {

int FilmPlan::frames() const {
    return std::max(1,
                    static_cast<int>(std::lround(seconds * static_cast<float>(framesPerSecond))));
}

int FilmPlan::firstFrame() const {
    return static_cast<int>(std::lround(from * static_cast<float>(framesPerSecond)));
}

float FilmPlan::timeOf(int frame) const {
    if (what == What::kTurn) return from;
    return static_cast<float>(firstFrame() + frame) / static_cast<float>(framesPerSecond);
}

Camera FilmPlan::cameraOf(int frame, const Camera& camera) const {
    if (what == What::kTime || frame == 0) return camera;
    const float angle =
        glm::two_pi<float>() * static_cast<float>(frame) / static_cast<float>(frames());
    const glm::quat turn = glm::angleAxis(angle, glm::vec3(0, 1, 0));
    Camera result = camera;
    result.eye = camera.target + turn * (camera.eye - camera.target);
    result.up = turn * camera.up;
    return result;
}

}  // namespace vitrine
