// SPDX-License-Identifier: MIT
#include "pack/pack_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/text.hpp"
#include "bvh/build.hpp"
#include "bvh/instance.hpp"
#include "pack/parameters.hpp"

namespace vitrine {
namespace {

std::array<glm::vec4, 3> rowsOf(const glm::mat4& m) {
    const glm::mat4 t = glm::transpose(m);
    return {t[0], t[1], t[2]};
}

/// Scales that multiply down a chain of parents leave the range of floats, where boxes and
/// inverses are no numbers.
bool isUsable(const glm::mat4& worldFromObject) {
    const glm::mat4 inverse = glm::inverse(worldFromObject);
    for (int column = 0; column < 4; ++column)
        for (const glm::mat4* m : {&worldFromObject, &inverse}) {
            const glm::vec3 v((*m)[column]);
            if (!isFinite(v) || glm::length(v) > kMaxCoordinate) return false;
        }
    return true;
}

glm::vec4 texel(int x, int y = 0, int z = 0, int w = 0) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
            static_cast<float>(w)};
}

/// Builds the arrays in the order in which they depend on each other.
class Packer {
  public:
    Packer(const Scene& scene, const Assets& assets, Diagnostics& diagnostics)
        : scene_(scene), assets_(assets), diagnostics_(diagnostics) {
        for (size_t i = 0; i < scene.shapes.size(); ++i) shapes_.emplace(scene.shapes[i].name, i);
        for (size_t i = 0; i < scene.materials.size(); ++i)
            materialNumbers_.emplace(scene.materials[i].name, static_cast<int>(i));
    }

    PackedScene pack() {
        collectSnippets();
        out_.textures = packMaterialTextures(scene_, assets_);
        packMaterials();
        packLights();
        packInstances();
        finishTables();
        packSettings();
        return std::move(out_);
    }

  private:
    struct PackedMesh {
        uint32_t root;
        int firstTriangle;
        /// What a vertex's number is added to for its texel in that list; 0: none.
        int extras = 0, tangents = 0;
    };

    /// Indices travel as floats, which are exact up to here.
    static constexpr size_t kLargestIndex = 1u << 24;

    void collectSnippets() {
        for (const auto& field : assets_.fields)
            if (field != nullptr) fieldNumber(field);
        for (const auto& snippet : assets_.materials)
            if (snippet != nullptr) materialNumber(snippet);
        out_.shaders = generateShaders(fields_, materialSnippets_);
    }

    /// The same file used twice is one field.
    static int number(std::vector<std::shared_ptr<const Snippet>>& list,
                      const std::shared_ptr<const Snippet>& snippet) {
        const auto found = std::find(list.begin(), list.end(), snippet);
        if (found != list.end()) return static_cast<int>(found - list.begin());
        list.push_back(snippet);
        return static_cast<int>(list.size()) - 1;
    }
    int fieldNumber(const std::shared_ptr<const Snippet>& s) { return number(fields_, s); }
    int materialNumber(const std::shared_ptr<const Snippet>& s) {
        return 1 + number(materialSnippets_, s);
    }

    int addParameters(const std::vector<glm::vec4>& values) {
        const auto first = static_cast<int>(parameters_.size());
        parameters_.insert(parameters_.end(), values.begin(), values.end());
        return first;
    }

    void packMaterials() {
        for (size_t i = 0; i < scene_.materials.size(); ++i) {
            int snippet = 0, parameters = 0;
            if (const auto& asset = assets_.materials[i]) {
                snippet = materialNumber(asset);
                parameters =
                    addParameters(parameterValues(*asset, scene_.materials[i].set, diagnostics_));
            } else if (!scene_.materials[i].set.empty() && scene_.materials[i].snippet.empty()) {
                diagnostics_.error(scene_.materials[i].set[0].where,
                                   "set gives parameters to a snippet, but the material has none");
            }
            addMaterial(scene_.materials[i], snippet, parameters, out_.textures.slots[i]);
        }
        addMaterial(Material{}, 0, 0, {});  // for nodes that name none
        out_.materialNames.back() = "(default)";
    }

    void addMaterial(const Material& m, int snippet, int parameters,
                     const PackedTextures::Slots& slots) {
        out_.materialNames.push_back(m.name);
        materials_.emplace_back(m.baseColor.rgb, m.metallic);
        materials_.emplace_back(m.emission.rgb * m.emissionStrength, m.roughness);
        materials_.push_back(texel(snippet, parameters, flagsOf(m)));
        materials_.push_back(texel(slots.first, slots.count));
        materials_.back().z = m.opacity;
        materials_.back().w = m.alphaCutoff;
        materials_.emplace_back(m.specularColor.rgb, m.ior);
        materials_.emplace_back(absorptionOf(m), m.transmission);
        materials_.emplace_back(m.clearcoat, m.clearcoatRoughness, m.specular, 0.0f);
        materials_.emplace_back(m.sheenColor.rgb, m.sheenRoughness);
    }

    static int flagsOf(const Material& m) {
        int flags = static_cast<int>(m.alphaMode);
        if (!m.doubleSided) flags |= VITRINE_MATERIAL_SINGLE_SIDED;
        if (m.unlit) flags |= VITRINE_MATERIAL_UNLIT;
        if (m.thin) flags |= VITRINE_MATERIAL_THIN;
        return flags;
    }

    /// Per metre (Beer's law).
    static glm::vec3 absorptionOf(const Material& m) {
        if (m.attenuationDistance <= 0) return glm::vec3(0);
        return -glm::log(glm::max(m.attenuationColor.rgb, glm::vec3(1e-6f))) /
               m.attenuationDistance;
    }

    void packLights() {
        for (const Light& light : scene_.lights) {
            lights_.emplace_back(light.at, static_cast<float>(light.type));
            lights_.emplace_back(light.color.rgb * light.intensity, light.range);
            lights_.emplace_back(glm::normalize(light.direction), 0.0f);
            lights_.emplace_back(std::cos(glm::radians(light.innerAngle)),
                                 std::cos(glm::radians(light.outerAngle)), 0.0f, 0.0f);
        }
    }

    const PackedMesh& packMesh(const std::shared_ptr<const MeshAsset>& asset) {
        const auto known = meshes_.find(asset.get());
        if (known != meshes_.end()) return known->second;
        const Mesh& mesh = *asset->mesh;
        const auto firstVertex =
            static_cast<uint32_t>(out_.vertices.size() / VITRINE_VERTEX_TEXELS);
        const auto firstTriangle = static_cast<int>(out_.triangles.size());
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            out_.vertices.emplace_back(mesh.positions[i], mesh.uvs[i].x);
            out_.vertices.emplace_back(mesh.normals[i], mesh.uvs[i].y);
        }
        for (size_t i = 0; i < mesh.triangles.size(); ++i)
            out_.triangles.emplace_back(mesh.triangles[i] + firstVertex, mesh.triangleParts[i]);
        const uint32_t root = layout_.addMesh(asset->bvh, mesh.positions, mesh.triangles);
        return meshes_[asset.get()] = {root, firstTriangle, packExtras(mesh, firstVertex),
                                       packTangents(mesh, firstVertex)};
    }

    /// Where a list of one texel a vertex, about to be appended, would begin for vertex 0.
    int beginList(uint32_t firstVertex) {
        const size_t texel = out_.vertices.size() - firstVertex;
        if (texel > kLargestIndex)
            diagnostics_.error({scene_.file},
                               "the scene is too large: more than 5 million vertices with colours, "
                               "second coordinates or tangents");
        return static_cast<int>(std::min(texel, kLargestIndex));
    }
    /// The vertices of the next mesh begin at a multiple of their texels.
    void endList() {
        while (out_.vertices.size() % VITRINE_VERTEX_TEXELS != 0) out_.vertices.emplace_back(0.0f);
    }

    /// Second texture coordinates, and the colour as two numbers of 12 bits in each of two floats.
    int packExtras(const Mesh& mesh, uint32_t firstVertex) {
        if (mesh.uvs2.empty() && mesh.colors.empty()) return 0;
        const int list = beginList(firstVertex);
        const auto joined = [](float a, float b) {
            const auto steps = [](float x) { return std::round(std::clamp(x, 0.0f, 1.0f) * 4095); };
            return steps(a) * 4096 + steps(b);
        };
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec2 uv = mesh.uvs2.empty() ? glm::vec2(0) : mesh.uvs2[i];
            const glm::vec4 c = mesh.colors.empty() ? glm::vec4(1) : mesh.colors[i];
            out_.vertices.emplace_back(uv.x, uv.y, joined(c.x, c.y), joined(c.z, c.w));
        }
        endList();
        out_.hasVertexExtras = true;
        return list;
    }

    int packTangents(const Mesh& mesh, uint32_t firstVertex) {
        if (mesh.tangents.empty()) return 0;
        const int list = beginList(firstVertex);
        out_.vertices.insert(out_.vertices.end(), mesh.tangents.begin(), mesh.tangents.end());
        endList();
        out_.hasTangents = true;
        return list;
    }

    int materialByName(const std::string& name) const {
        const auto found = materialNumbers_.find(name);
        return found == materialNumbers_.end() ? -1 : found->second;
    }

    /// First texel, in the lists, of the materials of a node's parts.
    int packPartMaterials(const Node& node, const Shape& shape,
                          const std::vector<std::string>& partNames) {
        const int unnamed = static_cast<int>(out_.materialNames.size()) - 1;
        const int whole = node.material.empty() ? unnamed : materialByName(node.material.name);
        std::vector<int> chosen(partNames.size(), whole);
        if (node.material.empty())
            for (size_t i = 0; i < shape.partMaterials.size() && i < partNames.size(); ++i)
                chosen[i] = materialByName(shape.partMaterials[i].second);
        for (size_t i = 0; i < node.parts.size(); ++i) {
            const auto& [part, material] = node.parts[i];
            const auto found = std::find(partNames.begin(), partNames.end(), part);
            if (found == partNames.end())
                diagnostics_.error(node.partPlaces[i],
                                   fmt::format("shape '{}' has no part '{}'{}; its parts are '{}'",
                                               node.shape.name, part, didYouMean(part, partNames),
                                               fmt::join(partNames, "', '")));
            else
                chosen[static_cast<size_t>(found - partNames.begin())] =
                    materialByName(material.name);
        }
        const auto first = static_cast<int>(materialLists_.size());
        for (const int material : chosen)
            materialLists_.push_back(texel(std::max(material, 0), static_cast<int>(chosen.size())));
        return first;
    }

    /// Parts of a field without names are called by their number.
    static std::vector<std::string> partNamesOf(const Snippet& field) {
        if (!field.partNames.empty() || !field.entryReturnsPart)
            return field.partNames.empty() ? std::vector<std::string>{"0"} : field.partNames;
        std::vector<std::string> numbers;
        for (int i = 0; i < 16; ++i) numbers.push_back(std::to_string(i));
        return numbers;
    }

    void packInstances() {
        const std::vector<glm::mat4> world = worldFromNodes(scene_);
        for (size_t i = 0; i < scene_.nodes.size(); ++i) {
            const Node& node = scene_.nodes[i];
            const auto named = shapes_.find(node.shape.name);
            if (named == shapes_.end()) continue;
            const Shape& shape = scene_.shapes[named->second];
            const auto& mesh = assets_.meshes[named->second];
            const auto& field = assets_.fields[named->second];
            if (field == nullptr && !node.set.empty() && shape.sdf.empty())
                diagnostics_.error(node.set[0].where, "only an SDF shape has parameters to set");
            if ((mesh == nullptr && field == nullptr) || !node.visible) continue;
            if (!isUsable(world[i])) {
                diagnostics_.error(
                    node.where,
                    fmt::format("with its parents, node '{}' is scaled or moved too far",
                                node.name));
                continue;
            }
            addInstance(node, shape, world[i], mesh, field);
        }
        out_.block.counts.z = addUpperLevel(false);
        out_.fieldRoot = out_.hasMeshes ? addUpperLevel(true) : out_.block.counts.z;
        out_.slots = layout_.texels();
        out_.stackBound = layout_.stackBound();
        if (out_.stackBound > VITRINE_STACK_SIZE)
            diagnostics_.error(
                {scene_.file},
                fmt::format("the scene's trees are too deep for the tracer's stack: {} "
                            "entries are needed, there are {}",
                            out_.stackBound, VITRINE_STACK_SIZE));
    }

    /// The tree over all instances, or over the fields alone. -1 if there are none.
    int addUpperLevel(bool fieldsOnly) {
        std::vector<Aabb> boxes;
        std::vector<uint32_t> numbers;
        for (size_t i = 0; i < out_.instances.size(); ++i) {
            if (fieldsOnly && !out_.instances[i].field) continue;
            boxes.push_back(out_.instances[i].worldBox);
            numbers.push_back(static_cast<uint32_t>(i));
        }
        if (boxes.empty()) return -1;
        BuildOptions options;
        options.maxLeafSize = 1;  // the shader takes a leaf of the upper level for one instance
        return static_cast<int>(layout_.addInstances(buildBvh(boxes, options), numbers));
    }

    void addInstance(const Node& node, const Shape& shape, const glm::mat4& worldFromObject,
                     const std::shared_ptr<const MeshAsset>& mesh,
                     const std::shared_ptr<const Snippet>& field) {
        const Aabb box = mesh != nullptr ? mesh->bvh.box() : *field->bounds;
        float perMeshOrField[2] = {0, 0};
        int firstTriangle = 0;
        glm::vec4 indices;
        if (mesh != nullptr) {
            const PackedMesh& packed = packMesh(mesh);
            firstTriangle = packed.firstTriangle;
            indices = texel(VITRINE_KIND_MESH, static_cast<int>(packed.root),
                            packPartMaterials(node, shape, mesh->mesh->partNames), firstTriangle);
            perMeshOrField[0] = static_cast<float>(packed.extras);
            perMeshOrField[1] = static_cast<float>(packed.tangents);
            out_.hasMeshes = true;
            out_.triangleCount += mesh->mesh->triangles.size();
        } else {
            const int parameters = addParameters(parameterValues(*field, node.set, diagnostics_));
            indices = texel(VITRINE_KIND_FIELD, fieldNumber(field),
                            packPartMaterials(node, shape, partNamesOf(*field)), parameters);
            perMeshOrField[0] = 1 / field->lipschitz.value_or(1.0f);  // the scale of steps
            // What the float arithmetic of a field of this size cannot tell from zero.
            const glm::vec3 size = glm::max(glm::abs(box.min), glm::abs(box.max));
            perMeshOrField[1] = 4e-6f * std::max(size.x, std::max(size.y, size.z));
            out_.hasFields = true;
        }
        for (const glm::vec4& row : rowsOf(glm::inverse(worldFromObject)))
            instances_.push_back(row);
        for (const glm::vec4& row : rowsOf(worldFromObject)) instances_.push_back(row);
        instances_.push_back(indices);
        instances_.emplace_back(box.min, perMeshOrField[0]);
        instances_.emplace_back(box.max, perMeshOrField[1]);

        const Aabb worldBox = instanceBox(box, worldFromObject);
        out_.worldBox.grow(worldBox);
        out_.instances.push_back({node.name, worldFromObject, worldBox, field != nullptr,
                                  firstTriangle,
                                  mesh != nullptr ? mesh->mesh->triangles.size() : 0});
    }

    /// Joins the tables; material lists get addresses of the whole.
    void finishTables() {
        const auto append = [&](const std::vector<glm::vec4>& part) {
            const auto first = static_cast<int>(out_.tables.size());
            out_.tables.insert(out_.tables.end(), part.begin(), part.end());
            return first;
        };
        (void)append(out_.textures.table);  // first: its addresses count from the beginning
        const int lists = append(materialLists_);
        for (size_t i = 6; i < instances_.size(); i += VITRINE_INSTANCE_TEXELS)
            instances_[i].z += static_cast<float>(lists);
        out_.block.tables.x = append(instances_);
        out_.block.tables.y = append(materials_);
        out_.block.tables.z = append(lights_);
        out_.block.tables.w = append(parameters_);
        if (std::max({out_.slots.size() / VITRINE_SLOT_TEXELS, out_.triangles.size(),
                      out_.tables.size()}) > kLargestIndex)
            diagnostics_.error({scene_.file},
                               "the scene is too large: more than 16 million triangles");
    }

    void packSettings() {
        FrameBlock& b = out_.block;
        const RenderSettings& r = scene_.render;
        const Environment& e = scene_.environment;
        b.background[0] = glm::vec4(e.zenith.rgb * e.intensity, 0);
        b.background[1] = glm::vec4(e.horizon.rgb * e.intensity, 0);
        b.background[2] = glm::vec4(e.ground.rgb * e.intensity, 0);
        b.shading = {0, r.threshold, r.ao, r.aoDistance};
        const float size = out_.worldBox.empty() ? 1.0f : glm::length(out_.worldBox.extent());
        b.display = {std::exp2(r.exposure), r.gamma, std::min(size, 10.0f), 1};
        b.image.z = static_cast<int>(r.toneMap);
        b.sampling.w = r.seed;
        b.counts.x = static_cast<int>(scene_.lights.size());
        b.counts.y = r.marchSteps;
        b.counts.w = VITRINE_LOOP_BUDGET;
    }

    const Scene& scene_;
    const Assets& assets_;
    Diagnostics& diagnostics_;
    PackedScene out_;
    BvhLayout layout_;
    std::vector<std::shared_ptr<const Snippet>> fields_, materialSnippets_;
    std::unordered_map<std::string, size_t> shapes_;
    std::unordered_map<std::string, int> materialNumbers_;
    std::map<const MeshAsset*, PackedMesh> meshes_;
    std::vector<glm::vec4> instances_, materials_, lights_, parameters_, materialLists_;
};

}  // namespace

PackedScene packScene(const Scene& scene, const Assets& assets, Diagnostics& diagnostics) {
    return Packer(scene, assets, diagnostics).pack();
}

}  // namespace vitrine
