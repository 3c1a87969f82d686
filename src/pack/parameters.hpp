// SPDX-License-Identifier: MIT
// Values for the parameters of a snippet: the scene's where it gives one, else the defaults.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "sdf/snippet.hpp"

namespace vitrine {

/// One value a parameter, in the snippet's order. Names the snippet does not have, values of the
/// wrong size or outside the range are errors at the place in the scene.
std::vector<glm::vec4> parameterValues(const Snippet& snippet,
                                       const std::vector<ParameterValue>& set,
                                       Diagnostics& diagnostics);

/// Appends values to a table; returns where they begin.
int addParameters(const std::vector<glm::vec4>& values, std::vector<glm::vec4>& table);

}  // namespace vitrine
