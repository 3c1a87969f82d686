// SPDX-License-Identifier: MIT
// Writes generated models and pictures. A file that has its bytes already is left alone, so that
// nothing reloads in vain.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "image/image.hpp"
#include "mesh/mesh.hpp"

namespace vitrine {

/// FOLDER/NAME.obj, with a group a part.
void writeModel(const std::filesystem::path& folder, const Mesh& mesh);
void writeText(const std::filesystem::path& path, std::string_view text);
/// As PNG.
void writePicture(const std::filesystem::path& path, const ImageRgba8& picture);

}  // namespace vitrine
