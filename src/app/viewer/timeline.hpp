// SPDX-License-Identifier: MIT
// The scene's time as it plays.
#pragma once

namespace vitrine {

/// What there is to play.
struct TimeSpan {
    float seconds = 0;     ///< until the last key of the animations; 0: nothing moves by itself
    bool hasKeys = false;  ///< else snippets only, which know no end
    bool endless = false;  ///< something moves on after that
};

struct Timeline {
    float time = 0;        ///< s
    float duration = 0;    ///< s, of what can be scrubbed through; 0: nothing moves by itself
    bool endless = false;  ///< grows when time comes to its end, unless it loops
    bool playing = false, loop = true;
    float grown = 0;  ///< what endless time has made of the duration, s

    /// What there is to play has changed.
    void fit(const TimeSpan& span);
    /// Goes on by `elapsed` seconds; returns whether the time has changed.
    bool advance(float elapsed);
};

}  // namespace vitrine
