// SPDX-License-Identifier: MIT
#include "scene/animation.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

/// `t` in [0, 1] to the share of the way from key to key.
double eased(Ease ease, double t) {
    switch (ease) {
        case Ease::kStep:
            return 0;
        case Ease::kSmooth:
            return t * t * (3 - 2 * t);
        case Ease::kSmoother:  // Perlin 2002: no jump of the acceleration either
            return t * t * t * (t * (6 * t - 15) + 10);
        case Ease::kIn:
            return t * t * t;
        case Ease::kOut:
            return 1 - (1 - t) * (1 - t) * (1 - t);
        case Ease::kLinear:
            break;
    }
    return t;
}

/// Time within the keys. The end of a loop that repeats is its start: the two are one moment.
double withinLoop(const AnimationTrack& track, double time) {
    const double start = track.loopStart, length = double(track.loopEnd) - start;
    if (track.loop == LoopMode::kNone || length <= 0) return time;
    const double rounds = (time - start) / length;
    if (track.loop == LoopMode::kRepeat) return start + length * (rounds - std::floor(rounds));
    const double there = rounds - 2 * std::floor(rounds / 2);  // 0 to 2, and back from 1
    return start + length * (there > 1 ? 2 - there : there);
}

glm::quat toQuat(const glm::vec4& v) {
    return glm::normalize(glm::quat(v.w, v.x, v.y, v.z));
}
glm::vec4 toVector(const glm::quat& q) {
    return {q.x, q.y, q.z, q.w};
}

/// The cubic Hermite spline between key `i` and the next, `t` in [0, 1]; `span` in seconds.
glm::vec4 cubic(const AnimationTrack& track, size_t i, float t, float span) {
    const glm::vec4* key = &track.values[3 * i + 1];
    const glm::vec4 &from = key[0], &leaving = key[1], &arriving = key[2], &to = key[3];
    const float t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * from + span * (t3 - 2 * t2 + t) * leaving +
           (3 * t2 - 2 * t3) * to + span * (t3 - t2) * arriving;
}

glm::vec4 keyValue(const AnimationTrack& track, size_t i) {
    return track.values[track.interpolation == Interpolation::kCubicSpline ? 3 * i + 1 : i];
}

glm::vec4 valueAt(const AnimationTrack& track, double time, bool quaternion) {
    const auto next = std::upper_bound(track.times.begin(), track.times.end(), time);
    if (next == track.times.begin()) return keyValue(track, 0);
    const auto i = static_cast<size_t>(next - track.times.begin()) - 1;
    if (next == track.times.end() || track.interpolation == Interpolation::kStep)
        return keyValue(track, i);
    const double span = double(track.times[i + 1]) - track.times[i];
    const auto t = static_cast<float>(eased(track.ease, (time - track.times[i]) / span));
    if (track.interpolation == Interpolation::kCubicSpline)
        return cubic(track, i, t, static_cast<float>(span));
    const glm::vec4 &from = track.values[i], &to = track.values[i + 1];
    if (quaternion) return toVector(glm::slerp(toQuat(from), toQuat(to), t));
    return glm::mix(from, to, t);
}

}  // namespace

glm::vec4 sampleTrack(const AnimationTrack& track, double time) {
    const bool quaternion = track.target.key == kOrientationKey;
    const glm::vec4 value = valueAt(track, withinLoop(track, time), quaternion);
    return quaternion ? toVector(toQuat(value)) : value;
}

}  // namespace vitrine
