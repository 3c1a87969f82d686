// SPDX-License-Identifier: MIT
// How a body and a camera ask a scene where the way is free.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/math.hpp"

namespace vitrine {

struct ProbeRay {
    glm::vec3 origin;     ///< world space, m
    glm::vec3 direction;  ///< unit
    float length;         ///< what is farther away does not count, m
};

struct ProbeHit {
    float distance;    ///< m
    glm::vec3 normal;  ///< unit, towards where the ray comes from
};

/// The nearest surface of each ray. Many rays at once cost little more than one.
using Probe = std::function<std::vector<std::optional<ProbeHit>>(std::span<const ProbeRay>)>;

}  // namespace vitrine
