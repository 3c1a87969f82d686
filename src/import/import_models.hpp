// SPDX-License-Identifier: MIT
// Models into a scene: what its nodes include and its shapes take from .gltf and .glb files.
//
// Names in the scene: materials are FILE/MATERIAL with the file's name without its ending, once a
// file; nodes, cameras and lights are NODE/NAME with the including node's name. A name that is
// taken gets #2, #3 and so on. Part names of all meshes are the names of the materials.
#pragma once

#include "import/model_library.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// Adds to the scene all that its models bring: nodes, shapes with their meshes, materials with
/// their pictures, cameras, and lights. Then carries out Scene::importOverrides and checks the
/// names that refer to models.
/// - A file outside of the scene's folder is an error at the place of its name; what is wrong in a
///   file is reported at its place in the file.
/// - Nodes that their transforms make too flat, small or large to draw are left out with a warning.
/// - Of a model's animations one plays, over and over: the first, with a warning if there are more,
///   or the one that the including node names. Cameras and lights go with the nodes they stand on.
///   A model that is one shape (`mesh = "f.glb"`) stands as it does at rest.
/// - Light is taken as the file's numbers say, a lux for 1 W/m2 and a candela for 1 W/sr, and is
///   not scaled with its node.
void importModels(Scene& scene, ModelLibrary& library, Diagnostics& diagnostics);

}  // namespace vitrine
