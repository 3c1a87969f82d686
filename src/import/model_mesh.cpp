// SPDX-License-Identifier: MIT
#include "import/model_mesh.hpp"

#include <algorithm>

#include "gltf/pose.hpp"
#include "import/model_material.hpp"
#include "import/model_names.hpp"
#include "mesh/tangents.hpp"
#include "scene/place.hpp"

namespace vitrine {
namespace {

/// Adds optional values to a mesh that may have none so far, or to one whose new part has none.
template <class T>
void appendOptional(std::vector<T>& to, size_t before, const std::vector<T>& from, size_t count,
                    const T& missing) {
    if (to.empty() && from.empty()) return;
    to.resize(before, missing);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, missing);
}

/// A model's mesh, moved, becomes part `part` of another.
void append(Mesh& to, const Mesh& from, uint32_t part) {
    const size_t before = to.positions.size(), count = from.positions.size();
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
    to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
    appendOptional(to.uvs2, before, from.uvs2, count, glm::vec2(0));
    appendOptional(to.colors, before, from.colors, count, glm::vec4(1));
    appendOptional(to.tangents, before, from.tangents, count, glm::vec4(0));
    for (const glm::uvec3& t : from.triangles)
        to.triangles.push_back(t + static_cast<uint32_t>(before));
    to.triangleParts.resize(to.triangles.size(), part);
}

/// The vertices that a primitive needs for its material.
Mesh prepared(const GltfModel& model, const GltfPrimitive& primitive) {
    Mesh mesh = primitive.mesh;
    const GltfMaterial standard;
    const GltfMaterial& material = primitive.material == kNoIndex
                                       ? standard
                                       : model.materials[static_cast<size_t>(primitive.material)];
    const bool bends = material.normalTexture.texture != kNoIndex ||
                       material.clearcoatNormalTexture.texture != kNoIndex;
    const GltfTextureInfo& normals = material.normalTexture.texture != kNoIndex
                                         ? material.normalTexture
                                         : material.clearcoatNormalTexture;
    if (mesh.tangents.empty() && bends) generateTangents(mesh, normals.texCoord == 1);
    if (!usesSecondUvs(material)) mesh.uvs2.clear();
    if (std::all_of(mesh.colors.begin(), mesh.colors.end(),
                    [](const glm::vec4& c) { return c == glm::vec4(1); }))
        mesh.colors.clear();
    return mesh;
}

/// Unit, where floats would overflow or vanish on the way.
glm::vec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? glm::vec3(v / length) : glm::vec3(0, 1, 0);
}

/// A tangent with a sign stands for a square frame. Where the transform slants one, the mesh is
/// left without tangents, and the renderer takes them from the edges of its triangles, which slant
/// along.
bool slantsTangents(const Mesh& mesh, const glm::dmat3& linear, const glm::dmat3& normalMatrix) {
    constexpr double kCosine = 0.9999;
    for (size_t i = 0; i < mesh.tangents.size(); ++i) {
        const glm::dvec3 n(mesh.normals[i]), t(mesh.tangents[i]);
        if (t == glm::dvec3(0)) continue;
        const glm::dvec3 moved = linear * glm::cross(n, t);
        const glm::dvec3 square = glm::cross(normalMatrix * n, linear * t);
        const double cosine = glm::dot(moved, square) / (glm::length(moved) * glm::length(square));
        if (std::abs(cosine) < kCosine) return true;
    }
    return false;
}

void move(Mesh& mesh, const glm::mat4& worldFromObject) {
    const glm::dmat3 linear(worldFromObject);
    const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(linear));
    // A reflection turns triangles inside out, and the cross product that gives the bitangent.
    const bool mirrors = glm::determinant(linear) < 0;
    if (slantsTangents(mesh, linear, normalMatrix)) mesh.tangents.clear();
    for (glm::vec3& p : mesh.positions) p = glm::vec3(worldFromObject * glm::vec4(p, 1));
    for (glm::vec3& n : mesh.normals) n = unit(normalMatrix * glm::dvec3(n));
    for (glm::vec4& t : mesh.tangents)
        if (glm::vec3(t) != glm::vec3(0))
            t = glm::vec4(unit(linear * glm::dvec3(t)), mirrors ? -t.w : t.w);
    if (mirrors)
        for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
}

/// What a transform has flattened or thrown out of range.
void dropUnusable(Mesh& mesh) {
    std::erase_if(mesh.triangles, [&](const glm::uvec3& t) {
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3& p = mesh.positions[t[corner]];
            if (!isFinite(p) || glm::any(glm::greaterThan(glm::abs(p), glm::vec3(kMaxCoordinate))))
                return true;
        }
        return isDegenerate(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    });
    if (mesh.triangles.empty()) return;
    // A vertex that is not used any more must not spoil the bounds.
    const glm::vec3 inside = mesh.positions[mesh.triangles[0].x];
    std::vector<bool> used(mesh.positions.size(), false);
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) used[t[corner]] = true;
    for (size_t i = 0; i < used.size(); ++i)
        if (!used[i]) mesh.positions[i] = inside;
}

class Joiner {
  public:
    explicit Joiner(const GltfModel& model) : model_(model), names_(partNamesOf(model)) {}

    void add(const GltfPrimitive& primitive, const glm::mat4* worldFromObject) {
        Mesh mesh = prepared(model_, primitive);
        if (worldFromObject != nullptr) {
            move(mesh, *worldFromObject);
            dropUnusable(mesh);
            if (mesh.triangles.empty()) return;
        }
        append(joined_.mesh, mesh, partOf(primitive.material));
    }

    std::optional<ModelMesh> finish() {
        if (joined_.mesh.triangles.empty()) return {};
        return std::move(joined_);
    }

  private:
    uint32_t partOf(int material) {
        const auto known = std::find(joined_.materials.begin(), joined_.materials.end(), material);
        const auto part = static_cast<uint32_t>(known - joined_.materials.begin());
        if (known == joined_.materials.end()) {
            joined_.materials.push_back(material);
            joined_.mesh.partNames.push_back(
                material == kNoIndex ? names_.back() : names_[static_cast<size_t>(material)]);
        }
        return part;
    }

    const GltfModel& model_;
    std::vector<std::string> names_;
    ModelMesh joined_;
};

/// Calls `visit(mesh, worldFromObject)` for each mesh of the scene to show.
template <class Visit>
void forEachPlacedMesh(const GltfModel& model, const std::vector<glm::mat4>& parentFromNodes,
                       const Visit& visit) {
    const std::vector<glm::mat4> world = worldFromNodes(model, parentFromNodes);
    for (const int node : nodesOfScene(model, model.scene))
        if (const int mesh = model.nodes[static_cast<size_t>(node)].mesh; mesh != kNoIndex)
            visit(model.meshes[static_cast<size_t>(mesh)], world[static_cast<size_t>(node)]);
}

}  // namespace

std::vector<std::string> partNamesOf(const GltfModel& model) {
    UniqueNames unique;
    std::vector<std::string> names;
    for (const GltfMaterial& material : model.materials)
        names.push_back(unique.make(material.name));
    names.push_back(unique.make("default"));
    return names;
}

std::optional<ModelMesh> joinMesh(const GltfModel& model, const GltfMesh& mesh) {
    Joiner joiner(model);
    for (const GltfPrimitive& primitive : mesh.primitives) joiner.add(primitive, nullptr);
    auto joined = joiner.finish();
    if (joined) joined->mesh.name = mesh.name;
    return joined;
}

std::optional<ModelMesh> joinScene(const GltfModel& model, size_t& skipped) {
    Joiner joiner(model);
    const auto visit = [&](const GltfMesh& mesh, const glm::mat4& worldFromObject) {
        if (!isUsablePlace(worldFromObject)) {
            ++skipped;
            return;
        }
        for (const GltfPrimitive& primitive : mesh.primitives)
            joiner.add(primitive, &worldFromObject);
    };
    forEachPlacedMesh(model, restPose(model), visit);
    return joiner.finish();
}

MeshSize sizeOfScene(const GltfModel& model) {
    MeshSize size;
    forEachPlacedMesh(model, restPose(model), [&](const GltfMesh& mesh, const glm::mat4&) {
        for (const GltfPrimitive& primitive : mesh.primitives) {
            size.vertices += primitive.mesh.positions.size();
            size.triangles += primitive.mesh.triangles.size();
        }
    });
    return size;
}

Aabb boundsOfScene(const GltfModel& model, const std::vector<glm::mat4>& parentFromNodes) {
    Aabb box;
    const auto visit = [&](const GltfMesh& mesh, const glm::mat4& worldFromObject) {
        if (!isUsablePlace(worldFromObject)) return;
        for (const GltfPrimitive& primitive : mesh.primitives)
            for (const glm::vec3& p : primitive.mesh.positions)
                box.grow(glm::vec3(worldFromObject * glm::vec4(p, 1)));
    };
    forEachPlacedMesh(model, parentFromNodes, visit);
    return box;
}

}  // namespace vitrine
