// SPDX-License-Identifier: MIT
#include "pack/pack_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "base/text.hpp"
#include "bvh/build.hpp"
#include "bvh/instance.hpp"
#include "pack/albedo_table.hpp"
#include "pack/check_animations.hpp"
#include "pack/pack_light.hpp"
#include "pack/pack_materials.hpp"
#include "pack/parameters.hpp"
#include "scene/place.hpp"
#include "scene/pose.hpp"

namespace vitrine {
namespace {

std::array<glm::vec4, 3> rowsOf(const glm::mat4& m) {
    const glm::mat4 t = glm::transpose(m);
    return {t[0], t[1], t[2]};
}

glm::vec4 texel(int x, int y = 0, int z = 0, int w = 0) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
            static_cast<float>(w)};
}

/// Builds the arrays of a moment in the order in which they depend on each other.
class Packer {
  public:
    Packer(const Scene& scene, const Assets& assets, const PackedGeometry& geometry,
           Diagnostics& diagnostics)
        : scene_(scene), assets_(assets), geometry_(geometry), diagnostics_(diagnostics) {
        for (size_t i = 0; i < scene.shapes.size(); ++i) shapes_.emplace(scene.shapes[i].name, i);
    }

    PackedMoment pack() {
        packLights();
        packInstances();
        finishTables();
        packSettings();
        return std::move(out_);
    }

  private:
    void packLights() {
        std::vector<PackedLight> lights;
        const std::vector<bool> visible = visibleNodes(scene_);
        for (const Light& light : scene_.lights)
            if (!light.node || visible[*light.node]) lights.push_back(packLight(light));
        if (geometry_.sky != nullptr && geometry_.sky->sun)
            lights.push_back(packLight(sunOfSky(*geometry_.sky->sun, scene_.environment)));
        // Those with a size first: rays look for them.
        const auto points = std::stable_partition(lights.begin(), lights.end(),
                                                  [](const PackedLight& l) { return l.sized; });
        out_.block.probes.x = static_cast<int>(points - lights.begin());
        out_.block.counts.x = static_cast<int>(lights.size());
        for (const PackedLight& light : lights)
            lights_.insert(lights_.end(), light.texels.begin(), light.texels.end());
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
        const std::vector<bool> visible = visibleNodes(scene_);
        std::vector<bool> moved;  // when it is asked for
        for (size_t i = 0; i < scene_.nodes.size(); ++i) {
            const Node& node = scene_.nodes[i];
            const auto named = shapes_.find(node.shape.name);
            if (named == shapes_.end()) continue;
            const Shape& shape = scene_.shapes[named->second];
            const auto& mesh = assets_.meshes[named->second];
            const auto& field = assets_.fields[named->second];
            if (field == nullptr && !node.set.empty() && shape.sdf.empty())
                diagnostics_.error(node.set[0].where, "only an SDF shape has parameters to set");
            if ((mesh == nullptr && field == nullptr) || !visible[i]) continue;
            if (field != nullptr && !field->box()) {
                diagnostics_.error({field->file}, "the field's bounds are not known");
                continue;
            }
            if (!isUsablePlace(world[i])) {
                // What moves may be elsewhere when its time comes.
                if (moved.empty()) moved = movedNodes(scene_);
                if (!moved[i] || !(glm::length(glm::vec3(world[i][3])) <= 1e18f))
                    diagnostics_.error(
                        node.where,
                        fmt::format("with its parents, node '{}' is scaled or moved too far",
                                    node.name));
                continue;
            }
            addInstance(i, world[i], named->second);
        }
        out_.block.counts.z = addUpperLevel(false);
        out_.fieldRoot = geometry_.hasMeshes ? addUpperLevel(true) : out_.block.counts.z;
        out_.upperSlots = layout_.texels();
        out_.stackBound = geometry_.meshStack + layout_.stackBound();
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

    void addInstance(size_t nodeNumber, const glm::mat4& worldFromObject, size_t shape) {
        const Node& node = scene_.nodes[nodeNumber];
        const Shape& shapeOfNode = scene_.shapes[shape];
        const auto& mesh = assets_.meshes[shape];
        const auto& field = assets_.fields[shape];
        const Aabb box = mesh != nullptr ? mesh->bvh.box() : *field->box();
        float perMeshOrField[2] = {0, 0};
        int firstTriangle = 0;
        glm::vec4 indices;
        if (mesh != nullptr) {
            const PackedMesh& packed = geometry_.meshes[shape];
            firstTriangle = packed.firstTriangle;
            indices =
                texel(VITRINE_KIND_MESH, static_cast<int>(packed.root),
                      materials_.addParts(node, shapeOfNode, mesh->mesh->partNames), firstTriangle);
            perMeshOrField[0] = static_cast<float>(packed.extras);
            perMeshOrField[1] = static_cast<float>(packed.tangents);
            out_.triangleCount += mesh->mesh->triangles.size();
        } else {
            const int parameters =
                addParameters(parameterValues(*field, node.set, diagnostics_), parameters_);
            indices =
                texel(VITRINE_KIND_FIELD, numberOf(field, geometry_.fieldSnippets),
                      materials_.addParts(node, shapeOfNode, partNamesOf(*field)), parameters);
            perMeshOrField[0] = 1 / field->stepDivisor();  // the scale of steps
            // What the float arithmetic of a field of this size cannot tell from zero.
            const glm::vec3 size = glm::max(glm::abs(box.min), glm::abs(box.max));
            perMeshOrField[1] = 4e-6f * std::max(size.x, std::max(size.y, size.z));
        }
        const int flags = materials_.instanceFlags(static_cast<int>(indices.z), field != nullptr);
        indices.x += static_cast<float>(flags);
        for (const glm::vec4& row : rowsOf(glm::inverse(worldFromObject)))
            instances_.push_back(row);
        for (const glm::vec4& row : rowsOf(worldFromObject)) instances_.push_back(row);
        instances_.push_back(indices);
        instances_.emplace_back(box.min, perMeshOrField[0]);
        instances_.emplace_back(box.max, perMeshOrField[1]);

        const Aabb worldBox = instanceBox(box, worldFromObject);
        out_.worldBox.grow(worldBox);
        out_.instances.push_back(
            {node.name, nodeNumber, worldFromObject, worldBox, field != nullptr, firstTriangle,
             mesh != nullptr ? mesh->mesh->triangles.size() : 0, box, mesh,
             (flags & VITRINE_INSTANCE_CULLED) != 0, (flags & VITRINE_INSTANCE_FILTERED) != 0,
             field != nullptr ? static_cast<int>(indices.y) : 0});
    }

    /// Joins the tables; material lists get addresses of the whole.
    void finishTables() {
        const auto append = [&](const std::vector<glm::vec4>& part) {
            const auto first = static_cast<int>(out_.tables.size());
            out_.tables.insert(out_.tables.end(), part.begin(), part.end());
            return first;
        };
        (void)append(geometry_.textures.table);  // first: its addresses count from the beginning
        writeStrengths(scene_, geometry_.textures, out_.tables);
        const int lists = append(materials_.lists());
        for (size_t i = 6; i < instances_.size(); i += VITRINE_INSTANCE_TEXELS)
            instances_[i].z += static_cast<float>(lists);
        out_.block.tables.x = append(instances_);
        out_.block.tables.y = append(materials_.materials());
        out_.block.tables.z = append(lights_);
        out_.block.tables.w = append(parameters_);
        out_.block.path.w = append(albedoTable());
        // Indices travel as floats, which are exact up to here.
        constexpr size_t kLargestIndex = 1u << 24;
        if (std::max({(geometry_.slots.size() + out_.upperSlots.size()) / VITRINE_SLOT_TEXELS,
                      geometry_.triangles.size(), out_.tables.size()}) > kLargestIndex)
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
        if (geometry_.sky != nullptr) {
            const SkyMap& map = geometry_.sky->map;
            // The sun stands over the middle of an atmosphere's picture, which is +x.
            const float turn = e.rotation + (e.atmosphere ? e.sunAzimuth - 90 : 0);
            b.sky = {map.scale * e.intensity, turn / 360,
                     static_cast<float>(map.levels.front().width), 0};
        }
        b.shading = {0, r.threshold, r.ao, r.aoDistance};
        const float size = out_.worldBox.empty() ? 1.0f : glm::length(out_.worldBox.extent());
        b.display = {std::exp2(r.exposure) * r.exposurePercent / 100, r.gamma,
                     std::min(size, 10.0f), 1};
        b.image.z = static_cast<int>(r.toneMap);
        b.sampling.w = r.seed;
        b.counts.y = r.marchSteps;
        b.counts.w = VITRINE_LOOP_BUDGET;
        const bool fields = out_.fieldRoot >= 0;
        b.quick.x = r.shadows == ShadowMethod::kPenumbra && b.probes.x > 0;
        b.quick.y = r.aoMode == OcclusionMethod::kTaps && r.ao > 0 && fields;
        out_.hasCones = b.quick.x != 0 || b.quick.y != 0;
    }

    const Scene& scene_;
    const Assets& assets_;
    const PackedGeometry& geometry_;
    Diagnostics& diagnostics_;
    PackedMoment out_;
    BvhLayout layout_{static_cast<uint32_t>(geometry_.slots.size() / VITRINE_SLOT_TEXELS)};
    std::unordered_map<std::string, size_t> shapes_;
    std::vector<glm::vec4> instances_, lights_, parameters_;
    MaterialPacker materials_{scene_, assets_, geometry_, out_, parameters_, diagnostics_};
};

}  // namespace

PackedMoment packMoment(const Scene& scene, const Assets& assets, const PackedGeometry& geometry,
                        Diagnostics& diagnostics) {
    return Packer(scene, assets, geometry, diagnostics).pack();
}

PackedScene packScene(const Scene& scene, const Assets& assets, Diagnostics& diagnostics) {
    PackedScene packed;
    static_cast<PackedGeometry&>(packed) = packGeometry(scene, assets);
    if (packed.tooLarge)
        diagnostics.error({scene.file},
                          "the scene is too large: more than 5 million vertices with colours, "
                          "second coordinates or tangents");
    static_cast<PackedMoment&>(packed) = packMoment(scene, assets, packed, diagnostics);
    checkAnimations(scene, assets, diagnostics);
    return packed;
}

}  // namespace vitrine
