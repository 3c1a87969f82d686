// SPDX-License-Identifier: MIT
#include "app/viewer/projection.hpp"

#include <algorithm>

namespace vitrine {

Projection::Projection(const Camera& camera, glm::vec2 pictureSize)
    : eye_(camera.eye),
      frame_(frameOf(camera)),
      size_(glm::max(pictureSize, glm::vec2(1))),
      height_(heightAtUnitDistance(camera, size_.x / size_.y)),
      nearest_(1e-3f * glm::distance(camera.eye, camera.target)) {}

glm::vec2 Projection::divided(glm::vec3 world) const {
    const glm::vec3 v = world - eye_;
    const glm::vec2 p(glm::dot(v, frame_.right), -glm::dot(v, frame_.up));
    return 0.5f * size_ + p * (size_.y / (height_ * depth(world)));
}

std::optional<glm::vec2> Projection::place(glm::vec3 world) const {
    if (!(depth(world) > nearest_)) return {};
    return divided(world);
}

std::optional<std::pair<glm::vec2, glm::vec2>> Projection::line(glm::vec3 a, glm::vec3 b) const {
    const float da = depth(a), db = depth(b);
    if (!(std::max(da, db) > nearest_)) return {};
    if (da < nearest_) a = glm::mix(a, b, (nearest_ - da) / (db - da));
    if (db < nearest_) b = glm::mix(b, a, (nearest_ - db) / (depth(a) - db));
    return std::pair(divided(a), divided(b));
}

Sight Projection::through(glm::vec2 place) const {
    const glm::vec2 p = (place - 0.5f * size_) * (height_ / size_.y);
    return {eye_, glm::normalize(p.x * frame_.right - p.y * frame_.up - frame_.back)};
}

float Projection::metresPerUnit(glm::vec3 world) const {
    return std::max(depth(world), 0.0f) * height_ / size_.y;
}

}  // namespace vitrine
