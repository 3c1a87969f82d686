// SPDX-License-Identifier: MIT
// Who carries the camera through a scene on foot: does not pass through walls, keeps the eye's
// height above the ground, climbs steps. Pure but for what it asks of the scene.
#pragma once

#include <optional>

#include "app/viewer/probe.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// An upright cylinder below the eye.
struct Body {
    float radius = 0.25f;
    float height = 1.65f;  ///< from its feet to the eye, m
    float step = 0.4f;     ///< what is lower does not stop it
};

/// Of a grown-up's proportions with the eye at this height, m.
Body bodyOf(float eyeHeight);

/// As far as a body can go from `eye` by `shift`: it stops at what stands in its way and slides
/// along it. `grounded`: what slopes less than a steep roof is ground and stops nobody.
glm::vec3 freeShift(glm::vec3 eye, glm::vec3 shift, const Body& body, bool grounded,
                    const Probe& probe);

class Walker {
  public:
    /// Goes by `metres` (right, up, forward), in `elapsed` seconds. Less than two metres above
    /// ground it walks: level, at a constant height, which going up and down changes. Higher up it
    /// flies where the camera looks. Walls stop it both ways. Returns whether the camera has moved.
    bool go(Camera& camera, glm::vec3 metres, float elapsed, const Probe& probe);
    /// On the ground, as of the last go().
    [[nodiscard]] bool walks() const { return eyeHeight_.has_value(); }

  private:
    void stand(const Camera& camera, const Probe& probe);
    bool walk(Camera& camera, glm::vec3 metres, float elapsed, const Probe& probe);
    bool fly(Camera& camera, glm::vec3 metres, const Probe& probe);

    std::optional<float> eyeHeight_;  ///< kept, m; nothing: flies
    std::optional<glm::vec3> eye_;    ///< where go() has left it; elsewhere somebody else moved it
    bool settled_ = true;             ///< the height is the one to keep
};

}  // namespace vitrine
