// SPDX-License-Identifier: MIT
// Hands on the camera: mouse and keys of a frame of the interface become moves of the camera.
#pragma once

#include <functional>
#include <optional>

#include "app/viewer/camera_control.hpp"

namespace vitrine {

class Pilot {
  public:
    Camera camera;
    /// Moves a camera by metres (right, up, forward) that a hand asks for in `elapsed` seconds, as
    /// far as the scene lets it; also called without a wish. Returns whether it moved.
    std::function<bool(Camera&, glm::vec3 metres, float elapsed)> legs;
    /// A point that a flight is to pass at half its way.
    std::function<std::optional<glm::vec3>(const Camera& from, const Camera& to)> detour;

    /// Takes what ImGui says of the mouse and the keys over a picture of this size (ImGui units,
    /// from the upper left). Returns whether the camera moved.
    bool steer(float elapsed, glm::vec2 pictureSize);
    /// Keys have come with Ctrl, which may be up by now: they do not mean a walk, unless there is
    /// one.
    void standStill() { meantOtherwise_ = meantOtherwise_ || !walking_; }
    /// Flies to another camera in `seconds`; any move by hand ends it.
    void flyTo(const Camera& goal, float seconds);
    /// Takes a camera of the scene, and from now on goes where it goes until a hand takes over.
    void take(const Camera& sceneCamera, float seconds);
    /// That camera as it is now, by time or because it was `edited`. Its lens always counts; where
    /// it stands counts unless a hand holds the camera, and after an edit even then.
    void follow(const Camera& sceneCamera, bool edited);
    /// A hand has taken it away from the scene's camera.
    [[nodiscard]] bool held() const { return held_; }
    [[nodiscard]] bool flying() const { return flight_.active(); }
    /// The cursor from the middle of the picture, in its heights, y up.
    [[nodiscard]] static glm::vec2 cursor(glm::vec2 pictureSize);
    /// Height of the picture at distance 1.
    [[nodiscard]] float viewHeight(glm::vec2 pictureSize) const;

  private:
    void depart(const Camera& goal, float seconds);
    bool dragged(glm::vec2 pictureSize);
    bool walked(float elapsed);
    Flight flight_;
    Camera followed_;
    bool held_ = false;
    bool walking_ = false;
    bool meantOtherwise_ = false;  ///< the keys to walk that are down
};

/// The ray through a point of the picture, as Pilot::cursor() gives it: its unit direction.
/// `height` is that of the picture at distance 1.
glm::vec3 directionThrough(const Camera& camera, glm::vec2 cursor, float height);

}  // namespace vitrine
