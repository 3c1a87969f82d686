// SPDX-License-Identifier: MIT
#include "pack/pack_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/text.hpp"
#include "bvh/build.hpp"
#include "bvh/instance.hpp"
#include "pack/parameters.hpp"

namespace vitrine {
namespace {

template <class T>
int indexByName(const std::vector<T>& objects, const std::string& name) {
    for (size_t i = 0; i < objects.size(); ++i)
        if (objects[i].name == name) return static_cast<int>(i);
    return -1;
}

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
        : scene_(scene), assets_(assets), diagnostics_(diagnostics) {}

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
    };

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
        const Mesh& mesh = asset->mesh;
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
        return meshes_[asset.get()] = {root, firstTriangle};
    }

    /// First texel, in the lists, of the materials of a node's parts.
    int packPartMaterials(const Node& node, const std::vector<std::string>& partNames) {
        const int unnamed = static_cast<int>(out_.materialNames.size()) - 1;
        const int whole =
            node.material.empty() ? unnamed : indexByName(scene_.materials, node.material.name);
        std::vector<int> chosen(partNames.size(), whole);
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
                    indexByName(scene_.materials, material.name);
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
            const int shape = indexByName(scene_.shapes, node.shape.name);
            if (shape < 0) continue;
            const auto& mesh = assets_.meshes[static_cast<size_t>(shape)];
            const auto& field = assets_.fields[static_cast<size_t>(shape)];
            if (field == nullptr && !node.set.empty() &&
                scene_.shapes[static_cast<size_t>(shape)].sdf.empty())
                diagnostics_.error(node.set[0].where, "only an SDF shape has parameters to set");
            if ((mesh == nullptr && field == nullptr) || !node.visible) continue;
            if (field != nullptr && !field->box()) {
                diagnostics_.error({field->file}, "the field's bounds are not known");
                continue;
            }
            if (!isUsable(world[i])) {
                diagnostics_.error(
                    node.where,
                    fmt::format("with its parents, node '{}' is scaled or moved too far",
                                node.name));
                continue;
            }
            addInstance(node, world[i], mesh, field);
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

    void addInstance(const Node& node, const glm::mat4& worldFromObject,
                     const std::shared_ptr<const MeshAsset>& mesh,
                     const std::shared_ptr<const Snippet>& field) {
        const Aabb box = mesh != nullptr ? mesh->bvh.box() : *field->box();
        float stepScale = 1, precision = 0;
        int firstTriangle = 0;
        glm::vec4 indices;
        if (mesh != nullptr) {
            const PackedMesh& packed = packMesh(mesh);
            firstTriangle = packed.firstTriangle;
            indices = texel(VITRINE_KIND_MESH, static_cast<int>(packed.root),
                            packPartMaterials(node, mesh->mesh.partNames), firstTriangle);
            out_.hasMeshes = true;
            out_.triangleCount += mesh->mesh.triangles.size();
        } else {
            const int parameters = addParameters(parameterValues(*field, node.set, diagnostics_));
            indices = texel(VITRINE_KIND_FIELD, fieldNumber(field),
                            packPartMaterials(node, partNamesOf(*field)), parameters);
            stepScale = 1 / field->stepDivisor();
            // What the float arithmetic of a field of this size cannot tell from zero.
            const glm::vec3 size = glm::max(glm::abs(box.min), glm::abs(box.max));
            precision = 4e-6f * std::max(size.x, std::max(size.y, size.z));
            out_.hasFields = true;
        }
        for (const glm::vec4& row : rowsOf(glm::inverse(worldFromObject)))
            instances_.push_back(row);
        for (const glm::vec4& row : rowsOf(worldFromObject)) instances_.push_back(row);
        instances_.push_back(indices);
        instances_.emplace_back(box.min, stepScale);
        instances_.emplace_back(box.max, precision);

        const Aabb worldBox = instanceBox(box, worldFromObject);
        out_.worldBox.grow(worldBox);
        out_.instances.push_back({node.name, worldFromObject, worldBox, field != nullptr,
                                  firstTriangle, mesh != nullptr ? mesh->mesh.triangles.size() : 0,
                                  box, mesh});
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
        // Indices travel as floats, which are exact up to here.
        constexpr size_t kLargestIndex = 1u << 24;
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
    std::map<const MeshAsset*, PackedMesh> meshes_;
    std::vector<glm::vec4> instances_, materials_, lights_, parameters_, materialLists_;
};

}  // namespace

PackedScene packScene(const Scene& scene, const Assets& assets, Diagnostics& diagnostics) {
    return Packer(scene, assets, diagnostics).pack();
}

}  // namespace vitrine
