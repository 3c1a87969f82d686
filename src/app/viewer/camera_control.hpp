// SPDX-License-Identifier: MIT
// How a hand moves a camera. Pure mathematics: no window, no scene.
//
// Angles in radians, lengths in metres, world space. Screen offsets are in heights of the picture,
// x to the right and y up, so that a drag does the same at any size of the window.
#pragma once

#include "scene/scene.hpp"

namespace vitrine {

/// A camera's frame: unit vectors, right-handed, looking along -z.
struct CameraFrame {
    glm::vec3 right, up, back;
};
CameraFrame frameOf(const Camera& camera);

/// Height at distance 1 of a picture that is `aspect` times as wide as high.
float heightAtUnitDistance(const Camera& camera, float aspect);

/// Turns the eye about the target; the horizon stays level and the pole is never passed.
void tumble(Camera& camera, glm::vec2 offset);
/// Turns the view about the eye, likewise. Here and below `height` is that at distance 1.
void lookAround(Camera& camera, glm::vec2 offset, float height);
/// Moves the camera so that the target's plane follows the cursor exactly.
void pan(Camera& camera, glm::vec2 offset, float height);
/// Moves towards the target by steps of a wheel; a step is a tenth of the way. What is under the
/// cursor (from the picture's middle, in heights) stays under it.
void dolly(Camera& camera, float steps, glm::vec2 cursor, float height);
/// Moves eye and target by metres: right, up (of the world), forward along the ground or, when
/// flying, along the view.
void walk(Camera& camera, glm::vec3 metres, bool flying);

/// A move from one camera to another: position and target mixed, orientation slerped, and the way
/// led over a point so that it goes around what stands between.
class Flight {
  public:
    Flight() = default;
    Flight(const Camera& from, const Camera& to, float seconds);
    /// A point that the eye's way passes at half time.
    void bendThrough(glm::vec3 point);
    /// Ends elsewhere, at the same time.
    void setGoal(const Camera& to);
    [[nodiscard]] bool active() const { return duration_ > 0; }
    /// The camera after `seconds` more; ends by itself, exactly at its goal.
    Camera advance(float seconds);
    void stop() { duration_ = 0; }
    /// The eye at a share of the way, 0 to 1.
    [[nodiscard]] glm::vec3 eyeAt(float share) const;

  private:
    Camera from_, to_;
    glm::quat worldFromCamera_[2];
    glm::vec3 bend_{0};
    float duration_ = 0, passed_ = 0;
};

/// A camera that looks at `point` from where `camera` is, at the distance at which a ball of
/// `radius` fills a good part of the picture.
Camera lookingAt(const Camera& camera, glm::vec3 point, float radius, float height);

}  // namespace vitrine
