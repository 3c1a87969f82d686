// SPDX-License-Identifier: MIT
// Hands on the camera: mouse and keys of a frame of the interface become moves of the camera.
#pragma once

#include "app/viewer/camera_control.hpp"

namespace vitrine {

class Pilot {
  public:
    Camera camera;

    /// Takes what ImGui says of the mouse and the keys over a picture of this size (ImGui units,
    /// from the upper left). Returns whether the camera moved.
    bool steer(float elapsed, glm::vec2 pictureSize);
    /// Flies to another camera in `seconds`; any move by hand ends it.
    void flyTo(const Camera& goal, float seconds);
    [[nodiscard]] bool flying() const { return flight_.active(); }
    /// The cursor from the middle of the picture, in its heights, y up.
    [[nodiscard]] static glm::vec2 cursor(glm::vec2 pictureSize);

  private:
    bool dragged(glm::vec2 pictureSize);
    bool walked(float elapsed);
    Flight flight_;
};

/// The ray through a point of the picture, as Pilot::cursor() gives it: its unit direction.
glm::vec3 directionThrough(const Camera& camera, glm::vec2 cursor);

}  // namespace vitrine
