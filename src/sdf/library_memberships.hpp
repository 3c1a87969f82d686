// SPDX-License-Identifier: MIT
// What the shapes of shaders/lib/sdf enclose, said a second time, for tests: for the first example
// of each, a test of membership that uses no distance. Where a membership can only be computed, it
// is by brute force over points of a curve.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "base/math.hpp"

namespace vitrine {

using Inside = std::function<bool(const glm::dvec3&)>;

/// By the name of the function.
std::map<std::string, Inside> memberships();

}  // namespace vitrine
