// SPDX-License-Identifier: MIT
// Which moments of a scene a film shows. Pure arithmetic: no window, no files.
#pragma once

#include "scene/scene.hpp"

namespace vitrine {

struct FilmPlan {
    enum class What {
        kTime,  ///< time passes
        kTurn,  ///< time stands still, and the camera goes once around its target
    };
    What what = What::kTime;
    float from = 0;     ///< s of the scene's time; with kTurn where it stands
    float seconds = 2;  ///< how long the film is
    int framesPerSecond = 30;

    /// At least one.
    [[nodiscard]] int frames() const;
    /// The first of them, as `render --frames` counts.
    [[nodiscard]] int firstFrame() const;
    /// The scene's time in a frame of the film, from 0: what `render --frames FIRST-LAST --fps N`
    /// draws, to the last bit.
    [[nodiscard]] float timeOf(int frame) const;
    /// The camera in a frame of the film: `camera` itself, or turned about the world's y axis
    /// through its target. The frame after the last one is the first, so that a film can loop.
    [[nodiscard]] Camera cameraOf(int frame, const Camera& camera) const;
};

}  // namespace vitrine
