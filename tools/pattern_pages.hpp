// SPDX-License-Identifier: MIT
// docs/patterns.md and the scenes for its pictures, from the comments of shaders/lib/material.
#pragma once

#include <string>

#include "sdf/library.hpp"

namespace vitrine {

/// Is it a function for materials, of docs/patterns.md rather than docs/sdf.md?
bool isPattern(const LibraryFunction& function);

/// The text of docs/patterns.md.
std::string patternPage();

/// A material snippet that shows the first pattern of a function.
std::string patternPictureMaterial(const LibraryFunction& function);
/// What it is shown on.
std::string patternPictureField(const LibraryFunction& function);
/// A scene with NAME.mat.glsl and NAME.sdf.glsl beside it.
std::string patternPictureScene(const LibraryFunction& function);

}  // namespace vitrine
