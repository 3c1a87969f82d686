// SPDX-License-Identifier: MIT
#include "app/viewer/timeline.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr float kGrowth = 10;  // s

}  // namespace

void Timeline::fit(const TimeSpan& span) {
    endless = span.endless;
    duration = endless ? std::max(grown, span.seconds) : span.seconds;
    if (duration <= 0) playing = false;
}

bool Timeline::advance(float elapsed) {
    if (!playing) return false;
    time += elapsed;
    if (time < duration) return true;
    if (loop) {
        time = std::fmod(time, duration);
    } else if (endless) {
        duration = grown = kGrowth * (std::floor(time / kGrowth) + 1);
    } else {
        time = duration;
        playing = false;
    }
    return true;
}

}  // namespace vitrine
