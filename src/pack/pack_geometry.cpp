// SPDX-License-Identifier: MIT
#include "pack/pack_geometry.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "pack/bvh_layout.hpp"

namespace vitrine {
namespace {

/// The same file used twice is one snippet.
std::vector<std::shared_ptr<const Snippet>> eachOnce(
    const std::vector<std::shared_ptr<const Snippet>>& snippets) {
    std::vector<std::shared_ptr<const Snippet>> list;
    for (const auto& snippet : snippets)
        if (snippet != nullptr && std::find(list.begin(), list.end(), snippet) == list.end())
            list.push_back(snippet);
    return list;
}

PackedMesh packMesh(const MeshAsset& asset, BvhLayout& layout, PackedGeometry& out) {
    const Mesh& mesh = asset.mesh;
    const auto firstVertex = static_cast<uint32_t>(out.vertices.size() / VITRINE_VERTEX_TEXELS);
    const auto firstTriangle = static_cast<int>(out.triangles.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        out.vertices.emplace_back(mesh.positions[i], mesh.uvs[i].x);
        out.vertices.emplace_back(mesh.normals[i], mesh.uvs[i].y);
    }
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        out.triangles.emplace_back(mesh.triangles[i] + firstVertex, mesh.triangleParts[i]);
    return {layout.addMesh(asset.bvh, mesh.positions, mesh.triangles), firstTriangle};
}

}  // namespace

PackedGeometry packGeometry(const Scene& scene, const Assets& assets) {
    PackedGeometry out;
    out.fieldSnippets = eachOnce(assets.fields);
    out.materialSnippets = eachOnce(assets.materials);
    out.shaders = generateShaders(out.fieldSnippets, out.materialSnippets);
    out.textures = packMaterialTextures(scene, assets);
    out.sky = assets.sky;

    std::set<std::string> used;
    for (const Node& node : scene.nodes) used.insert(node.shape.name);
    BvhLayout layout;
    std::map<const MeshAsset*, PackedMesh> packed;
    out.meshes.resize(scene.shapes.size());
    for (size_t i = 0; i < scene.shapes.size(); ++i) {
        if (used.count(scene.shapes[i].name) == 0) continue;
        if (assets.fields[i] != nullptr) out.hasFields = true;
        const MeshAsset* mesh = assets.meshes[i].get();
        if (mesh == nullptr) continue;
        out.hasMeshes = true;
        const auto [known, isNew] = packed.try_emplace(mesh);
        if (isNew) known->second = packMesh(*mesh, layout, out);
        out.meshes[i] = known->second;
    }
    out.slots = layout.texels();
    out.meshStack = layout.stackBound();
    return out;
}

}  // namespace vitrine
