// SPDX-License-Identifier: MIT
// From the world into the picture of a camera and back. Places in the picture are in ImGui units
// from its upper left.
#pragma once

#include <optional>
#include <utility>

#include "app/viewer/camera_control.hpp"
#include "app/viewer/handle_math.hpp"

namespace vitrine {

class Projection {
  public:
    Projection(const Camera& camera, glm::vec2 pictureSize);

    /// Nothing for what is behind the eye, or as good as in it.
    [[nodiscard]] std::optional<glm::vec2> place(glm::vec3 world) const;
    /// The part of a line that is before the eye.
    [[nodiscard]] std::optional<std::pair<glm::vec2, glm::vec2>> line(glm::vec3 a,
                                                                      glm::vec3 b) const;
    [[nodiscard]] Sight through(glm::vec2 place) const;
    /// Metres that an ImGui unit covers at this point; 0 behind the eye.
    [[nodiscard]] float metresPerUnit(glm::vec3 world) const;

    [[nodiscard]] glm::vec3 eye() const { return eye_; }
    [[nodiscard]] const CameraFrame& frame() const { return frame_; }
    [[nodiscard]] glm::vec2 pictureSize() const { return size_; }

  private:
    [[nodiscard]] float depth(glm::vec3 world) const {
        return -glm::dot(world - eye_, frame_.back);
    }
    [[nodiscard]] glm::vec2 divided(glm::vec3 world) const;

    glm::vec3 eye_;
    CameraFrame frame_;
    glm::vec2 size_;
    float height_;   ///< of the picture at distance 1
    float nearest_;  ///< m
};

}  // namespace vitrine
