// SPDX-License-Identifier: MIT
// A model or a field without a scene: a scene is written around it, in the scene format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/field_prober.hpp"
#include "base/error.hpp"
#include "import/model_library.hpp"

namespace vitrine {

/// True if the file's name says that it is no scene but something to be shown in one.
bool isBareFile(const std::filesystem::path& file);

/// The text of a scene in the file's folder that shows it on a plinth in good light. Nothing, with
/// diagnostics, if the file cannot be read. `prober` finds the bounds of a field that has none.
/// A model in metres (.gltf, .glb) keeps its size and its own materials; the plinth, the floor and
/// the camera fit themselves to it. If it brings lights, they replace the sun; its cameras come
/// after the plinth's own. `library` keeps the model for importModels().
std::optional<std::string> sceneAround(const std::filesystem::path& file, ModelLibrary& library,
                                       FieldProber& prober, Diagnostics& diagnostics);

}  // namespace vitrine
