// SPDX-License-Identifier: MIT
// The scene's time as it plays.
#pragma once

namespace vitrine {

struct Timeline {
    float time = 0;      ///< s
    float duration = 0;  ///< s; 0: the scene has no animations and time is of snippets only
    bool playing = false, loop = true;

    /// Goes on by `elapsed` seconds; returns whether the time has changed.
    bool advance(float elapsed);
};

}  // namespace vitrine
