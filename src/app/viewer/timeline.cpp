// SPDX-License-Identifier: MIT
#include "app/viewer/timeline.hpp"

#include <cmath>

namespace vitrine {

bool Timeline::advance(float elapsed) {
    if (!playing) return false;
    time += elapsed;
    if (duration <= 0 || time < duration) return true;
    if (loop) {
        time = std::fmod(time, duration);
    } else {
        time = duration;
        playing = false;
    }
    return true;
}

}  // namespace vitrine
