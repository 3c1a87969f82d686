// SPDX-License-Identifier: MIT
// Flights that go round what stands between, and end square in front of screens.
#pragma once

#include <optional>

#include "app/viewer/camera_control.hpp"
#include "app/viewer/probe.hpp"
#include "base/aabb.hpp"

namespace vitrine {

/// Whether nothing stands in the way of the eye.
bool isFree(const Flight& flight, const Probe& probe);

/// A point for Flight::bendThrough() by which the flight goes round what stands in its way, over it
/// rather than beside it, as near as there is room. Nothing if the straight way is free, or none.
std::optional<glm::vec3> wayRound(const Camera& from, const Camera& to, const Probe& probe);

/// A thing that is looked at from its front: a picture, a screen, a sign.
struct Screen {
    glm::vec3 centre, normal, right, up;  ///< unit; the normal towards the eye
    float width, height;                  ///< m
};
/// What has bounds like one: thinner than 2 % of its shorter side, that not less than a quarter of
/// the longer one, and upright enough that a floor is none.
std::optional<Screen> screenOf(const Aabb& box, const glm::mat4& worldFromBox, glm::vec3 eye);
/// The camera square in front of it, as near as all of it is in a picture `aspect` times as wide as
/// high.
Camera squareInFront(const Camera& camera, const Screen& screen, float aspect);
/// Whether nothing stands between a screen and that camera.
bool isSeen(const Screen& screen, const Camera& camera, const Probe& probe);

}  // namespace vitrine
