// SPDX-License-Identifier: MIT
// `--set` of what comes with the models that a scene includes. Names from models have a slash in
// them, as in material.car/Paint.roughness=0.1, and may have dots: the key is behind the last one.
#pragma once

#include <string>

#include "base/error.hpp"
#include "scene/document.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// True if the assignment can only be to something of a model: the document has nothing of that
/// name. Such ones wait until the models have been read.
bool namesImported(const toml::table& document, const std::string& assignment);

/// Carries out one KEY=VALUE on a material, node or light of the scene.
void applyImportOverride(Scene& scene, const std::string& assignment, Diagnostics& diagnostics);

}  // namespace vitrine
