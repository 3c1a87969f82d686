// SPDX-License-Identifier: MIT
// The triangles of a model as meshes whose parts are its materials.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gltf/model.hpp"

namespace vitrine {

/// A mesh and the material of each of its parts; kNoIndex: the file gives none.
struct ModelMesh {
    Mesh mesh;
    std::vector<int> materials;
};

/// Names of the materials, made unique, and last that of triangles without one. Names of parts.
std::vector<std::string> partNamesOf(const GltfModel& model);

/// All primitives of a mesh; none if it has no triangles. Second uvs are kept where a texture uses
/// them, colours where they are not all white. Tangents are the file's; where it has none and a
/// normal map needs them, they are generated.
std::optional<ModelMesh> joinMesh(const GltfModel& model, const GltfMesh& mesh);

/// All meshes of the scene to show, each where its node puts it. Nodes whose place in the world is
/// unusable are left out and counted in `skipped`.
std::optional<ModelMesh> joinScene(const GltfModel& model, size_t& skipped);

/// Vertices and triangles that joinScene() makes; a small file can make very many.
struct MeshSize {
    uint64_t vertices = 0, triangles = 0;
};
MeshSize sizeOfScene(const GltfModel& model);

/// The box around all of the scene to show, by its vertices, with its nodes in a pose.
Aabb boundsOfScene(const GltfModel& model, const std::vector<glm::mat4>& parentFromNodes);

}  // namespace vitrine
