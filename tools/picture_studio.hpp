// SPDX-License-Identifier: MIT
// Where the pictures of the manuals are taken: one shape on a bright floor in the sun.
#pragma once

#include <string>

namespace vitrine {

/// The text of a scene with the field NAME.sdf.glsl. `camera` and `material` are the lines of these
/// tables; the floor lies at the height `floor`, m.
std::string pictureStudio(const std::string& name, const std::string& camera,
                          const std::string& material, double floor);

}  // namespace vitrine
