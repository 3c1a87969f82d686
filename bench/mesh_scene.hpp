// SPDX-License-Identifier: MIT
// A mesh with a given tree as a packed scene of one instance.
#pragma once

#include <span>

#include "bvh/build.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

inline PackedScene packTree(std::span<const glm::vec3> positions,
                            std::span<const glm::uvec3> triangles, const Bvh& bvh) {
    auto asset = std::make_shared<MeshAsset>();
    Mesh mesh;
    mesh.positions.assign(positions.begin(), positions.end());
    mesh.triangles.assign(triangles.begin(), triangles.end());
    mesh.normals.assign(positions.size(), glm::vec3(0, 1, 0));
    mesh.uvs.assign(positions.size(), glm::vec2(0));
    mesh.triangleParts.assign(triangles.size(), 0);
    mesh.partNames = {"default"};
    asset->mesh = std::make_shared<Mesh>(std::move(mesh));
    asset->bvh = bvh;
    Scene scene;
    scene.shapes.emplace_back().name = "shape";
    scene.nodes.emplace_back().shape.name = "shape";
    Assets assets;
    assets.meshes = {asset};
    assets.fields = {nullptr};
    Diagnostics diagnostics;
    PackedScene packed = packScene(scene, assets, diagnostics);
    diagnostics.throwIfErrors();
    return packed;
}

}  // namespace vitrine
