// SPDX-License-Identifier: MIT
// docs/sdf.md and the scenes for its pictures, from the comments of shaders/lib/sdf.
#pragma once

#include <filesystem>
#include <string>

#include "sdf/library.hpp"

namespace vitrine {

/// The text of docs/sdf.md.
std::string sdfPage();

/// A field that shows the first example of a function, cut off 1.2 m from the middle. A plane shape
/// is extruded.
std::string sdfPictureField(const LibraryFunction& function);
/// A scene with the field of the file NAME.sdf.glsl beside it.
std::string sdfPictureScene(const LibraryFunction& function);

}  // namespace vitrine
