// SPDX-License-Identifier: MIT
#include "frame/in_view.hpp"

#include <algorithm>
#include <array>

namespace vitrine {

bool isOutside(const Aabb& box, const glm::mat4& clipFromWorld) {
    std::array<int, 4> beyond{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p((corner & 1) != 0 ? box.max.x : box.min.x,
                          (corner & 2) != 0 ? box.max.y : box.min.y,
                          (corner & 4) != 0 ? box.max.z : box.min.z);
        const glm::vec4 clip = clipFromWorld * glm::vec4(p, 1);
        // Also right for corners behind the eye, where w is negative.
        beyond[0] += clip.x < -clip.w;
        beyond[1] += clip.x > clip.w;
        beyond[2] += clip.y < -clip.w;
        beyond[3] += clip.y > clip.w;
    }
    return std::find(beyond.begin(), beyond.end(), 8) != beyond.end();
}

float farthestDistance(const Aabb& box, const glm::vec3& eye) {
    return glm::length(glm::max(glm::abs(box.min - eye), glm::abs(box.max - eye)));
}

}  // namespace vitrine
