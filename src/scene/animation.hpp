// SPDX-License-Identifier: MIT
// A number, vector, colour or rotation that changes with time.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/math.hpp"

namespace vitrine {

/// The object of a scene and the option of it that a track moves.
struct AnimationTarget {
    enum class Object { kRender, kEnvironment, kCamera, kLight, kMaterial, kNode };
    Object object = Object::kNode;
    size_t index = 0;  ///< in the scene's list of such objects; 0 for render and environment
    /// As `--set` names it: "at", "color", "set.PARAMETER". Of a node also kOrientationKey.
    std::string key;

    auto operator<=>(const AnimationTarget&) const = default;
};

/// Node::orientation, a unit quaternion x y z w: for the rotations of models. Not in scene files.
inline constexpr const char* kOrientationKey = "orientation";

/// How a value goes from a key to the next. kCubicSpline is glTF's, with tangents.
enum class Interpolation { kLinear, kStep, kCubicSpline };

/// How time passes between two keys: evenly, or slowly at one end or both.
enum class Ease { kLinear, kStep, kSmooth, kSmoother, kIn, kOut };

/// What comes after the last key: its value stays, or all of it again, or backwards and again.
enum class LoopMode { kNone, kRepeat, kMirror };

struct AnimationTrack {
    AnimationTarget target;
    std::vector<float> times;  ///< s, each larger than the one before; at least one
    /// One a time; three for kCubicSpline: in-tangent, value, out-tangent, per second. Numbers are
    /// in x, truth values 0 or 1, quaternions x y z w.
    std::vector<glm::vec4> values;
    int components = 1;  ///< of a snippet's parameter: 1 to 4
    Interpolation interpolation = Interpolation::kLinear;
    Ease ease = Ease::kLinear;
    LoopMode loop = LoopMode::kNone;
    /// What a loop repeats, s; of the tracks of one model the same, whatever their own keys.
    float loopStart = 0, loopEnd = 0;
    SourceLocation where;
};

/// The value at a time. Before the first key it is the first one's unless the track loops.
/// Quaternions (target.key) turn the shorter way round at an even speed (Shoemake 1985) and come
/// out normalised. Source of kCubicSpline: glTF 2.0, appendix C.
glm::vec4 sampleTrack(const AnimationTrack& track, double time);

}  // namespace vitrine
