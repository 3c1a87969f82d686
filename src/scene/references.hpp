// SPDX-License-Identifier: MIT
// What one section of a scene says of another: names, and parents.
#pragma once

#include "scene/scene.hpp"

namespace vitrine {

/// Reports names that nothing has, names that two things have, and nodes that are their own
/// ancestors; those lose their parent. Names from models, which have a slash in them, are left to
/// the second check if the scene has models.
void checkReferences(Scene& scene, Diagnostics& diagnostics);

/// When the models have been read: the rest of the names, and ancestors again.
void checkImportedReferences(Scene& scene, Diagnostics& diagnostics);

/// True if the scene names a .gltf or .glb file.
bool importsModels(const Scene& scene);
/// True if the name says so.
bool isModelFile(std::string_view name);

}  // namespace vitrine
