// SPDX-License-Identifier: MIT
#include "pack/pack_geometry.hpp"

#include <algorithm>
#include <cmath>
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

/// Indices travel as floats, which are exact up to here.
constexpr size_t kLargestIndex = 1u << 24;

/// Where a list of one texel a vertex, about to be appended, would begin for vertex 0.
int beginList(uint32_t firstVertex, PackedGeometry& out) {
    const size_t texel = out.vertices.size() - firstVertex;
    out.tooLarge = out.tooLarge || texel > kLargestIndex;
    return static_cast<int>(std::min(texel, kLargestIndex));
}

/// The vertices of the next mesh begin at a multiple of their texels.
void endList(PackedGeometry& out) {
    while (out.vertices.size() % VITRINE_VERTEX_TEXELS != 0) out.vertices.emplace_back(0.0f);
}

/// Second texture coordinates, and the colour as two numbers of 12 bits in each of two floats.
int packExtras(const Mesh& mesh, uint32_t firstVertex, PackedGeometry& out) {
    if (mesh.uvs2.empty() && mesh.colors.empty()) return 0;
    const int list = beginList(firstVertex, out);
    const auto joined = [](float a, float b) {
        const auto steps = [](float x) { return std::round(std::clamp(x, 0.0f, 1.0f) * 4095); };
        return steps(a) * 4096 + steps(b);
    };
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec2 uv = mesh.uvs2.empty() ? glm::vec2(0) : mesh.uvs2[i];
        const glm::vec4 c = mesh.colors.empty() ? glm::vec4(1) : mesh.colors[i];
        out.vertices.emplace_back(uv.x, uv.y, joined(c.x, c.y), joined(c.z, c.w));
    }
    endList(out);
    out.hasVertexExtras = true;
    return list;
}

int packTangents(const Mesh& mesh, uint32_t firstVertex, PackedGeometry& out) {
    if (mesh.tangents.empty()) return 0;
    const int list = beginList(firstVertex, out);
    out.vertices.insert(out.vertices.end(), mesh.tangents.begin(), mesh.tangents.end());
    endList(out);
    out.hasTangents = true;
    return list;
}

PackedMesh packMesh(const MeshAsset& asset, BvhLayout& layout, PackedGeometry& out) {
    const Mesh& mesh = *asset.mesh;
    const auto firstVertex = static_cast<uint32_t>(out.vertices.size() / VITRINE_VERTEX_TEXELS);
    const auto firstTriangle = static_cast<int>(out.triangles.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        out.vertices.emplace_back(mesh.positions[i], mesh.uvs[i].x);
        out.vertices.emplace_back(mesh.normals[i], mesh.uvs[i].y);
    }
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        out.triangles.emplace_back(mesh.triangles[i] + firstVertex, mesh.triangleParts[i]);
    const uint32_t root = layout.addMesh(asset.bvh, mesh.positions, mesh.triangles);
    return {root, firstTriangle, packExtras(mesh, firstVertex, out),
            packTangents(mesh, firstVertex, out)};
}

}  // namespace

int numberOf(const std::shared_ptr<const Snippet>& snippet,
             const std::vector<std::shared_ptr<const Snippet>>& list) {
    return static_cast<int>(std::find(list.begin(), list.end(), snippet) - list.begin());
}

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
