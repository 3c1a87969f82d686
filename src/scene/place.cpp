// SPDX-License-Identifier: MIT
#include "scene/place.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {

bool isUsablePlace(const glm::mat4& worldFromObject) {
    constexpr float kLargest = 1e18f;  // as the coordinates of meshes: its square is a float, too
    const glm::mat4 inverse = glm::inverse(worldFromObject);
    for (int column = 0; column < 4; ++column)
        for (const glm::mat4* m : {&worldFromObject, &inverse})
            // Also false of what is no number.
            if (!(glm::length(glm::vec3((*m)[column])) <= kLargest)) return false;
    return true;
}

void placeOn(const glm::mat4& worldFromNode, Camera& camera) {
    camera.eye = glm::vec3(worldFromNode[3]);
    // Far from the origin, a near target would be lost in rounding.
    camera.target = camera.eye - glm::normalize(glm::vec3(worldFromNode[2])) *
                                     std::max(1.0f, glm::length(camera.eye));
    camera.up = glm::vec3(worldFromNode[1]);
}

void placeOn(const glm::mat4& worldFromNode, Light& light) {
    light.at = glm::vec3(worldFromNode[3]);
    light.direction = -glm::normalize(glm::vec3(worldFromNode[2]));
}

}  // namespace vitrine
