// SPDX-License-Identifier: MIT
#include "app/viewer/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pack/hit_record.hpp"

namespace vitrine {
namespace {

/// What the shader does in loadMaterial() (shaders/shade/surface.glsl).
std::string materialName(const PackedMoment& moment, size_t instance, int part) {
    const auto first = static_cast<size_t>(moment.block.tables.x);
    const glm::vec4 indices = moment.tables[first + instance * VITRINE_INSTANCE_TEXELS + 6];
    const auto list = static_cast<size_t>(indices.z);
    const int last = static_cast<int>(moment.tables[list].y) - 1;
    const auto entry = list + static_cast<size_t>(std::clamp(part, 0, last));
    return moment.materialNames[static_cast<size_t>(moment.tables[entry].x)];
}

std::string partText(int part, const std::vector<std::string>& names) {
    const auto i = static_cast<size_t>(part);
    return i < names.size() ? fmt::format("{} ({})", part, names[i]) : std::to_string(part);
}

}  // namespace

Facts inspect(const PackedGeometry& geometry, const PackedMoment& moment, const glm::uvec4& record,
              const glm::vec3& eye, const glm::vec3& direction) {
    if (!record::isSurface(record) || record.x >= moment.instances.size()) return {{"", "nothing"}};
    const PackedInstance& instance = moment.instances[record.x];
    Facts facts{{"node", instance.name}};
    int part = 0;
    if (instance.field) {
        part = static_cast<int>(record::fieldPart(record));
        const Snippet& field = *geometry.fieldSnippets[static_cast<size_t>(instance.snippet)];
        facts.emplace_back("kind", "field " + field.file);
        facts.emplace_back("part", partText(part, field.partNames));
    } else {
        if (record.y >= instance.triangles) return {{"", "nothing"}};
        const size_t triangle = static_cast<size_t>(instance.firstTriangle) + record.y;
        part = static_cast<int>(geometry.triangles[triangle].w);
        facts.emplace_back("kind", "mesh");
        facts.emplace_back("triangle", fmt::format("{} of {}", record.y, instance.triangles));
        facts.emplace_back("part", partText(part, instance.mesh->mesh->partNames));
    }
    facts.emplace_back("material", materialName(moment, record.x, part));
    const float distance = record::recordDistance(record);
    const glm::vec3 p = eye + distance * direction;
    facts.emplace_back("distance", fmt::format("{:.4g} m", distance));
    facts.emplace_back("position", fmt::format("{:.4g}  {:.4g}  {:.4g}", p.x, p.y, p.z));
    return facts;
}

}  // namespace vitrine
