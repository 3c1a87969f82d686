// SPDX-License-Identifier: MIT
#include "app/viewer/surroundings.hpp"

#include <algorithm>

#include "pack/hit_record.hpp"

namespace vitrine {
namespace {

constexpr float kCone = 1e-3f;  // m: fields are found to a part of this

/// Of the triangle, in the world, towards where the ray comes from.
glm::vec3 normalOf(const Mesh& mesh, uint32_t triangle, const glm::mat4& worldFromObject,
                   glm::vec3 direction) {
    const glm::uvec3 t = mesh.triangles[triangle];
    const auto edge = [&](unsigned corner) {
        return glm::mat3(worldFromObject) * (mesh.positions[corner] - mesh.positions[t.x]);
    };
    const glm::vec3 n = glm::cross(edge(t.y), edge(t.z));
    const float length = glm::length(n);
    if (!(length > 0)) return -direction;
    return glm::dot(n, direction) > 0 ? -n / length : n / length;
}

}  // namespace

MeshSurroundings::MeshSurroundings(const PackedMoment& moment) {
    for (const PackedInstance& instance : moment.instances) {
        if (instance.field) continue;
        const auto known = std::find(assets_.begin(), assets_.end(), instance.mesh);
        const auto number = static_cast<uint32_t>(known - assets_.begin());
        if (known == assets_.end()) {
            assets_.push_back(instance.mesh);
            const Mesh& mesh = *instance.mesh->mesh;
            views_.push_back({&instance.mesh->bvh, mesh.positions, mesh.triangles});
        }
        instances_.push_back({instance.worldFromObject, number});
    }
    tree_ = buildInstanceBvh(instances_, views_);
}

std::optional<ProbeHit> MeshSurroundings::closest(const ProbeRay& ray) const {
    const auto hit =
        sceneClosestHit(tree_, instances_, views_, {ray.origin, ray.direction, 0, ray.length});
    if (!hit) return {};
    const Instance& instance = instances_[hit->instance];
    return ProbeHit{hit->hit.t, normalOf(*assets_[instance.mesh]->mesh, hit->hit.triangle,
                                         instance.worldFromObject, ray.direction)};
}

void Surroundings::follow() {
    if (meshes_ && moment_ == view_.moments()) return;
    moment_ = view_.moments();
    const std::vector<PackedInstance>& instances = view_.moment().instances;
    fields_ = std::any_of(instances.begin(), instances.end(),
                          [](const PackedInstance& i) { return i.field; });
    meshes_.emplace(view_.moment());
}

std::vector<std::optional<ProbeHit>> Surroundings::operator()(std::span<const ProbeRay> rays) {
    follow();
    if (fields_) return askGpu(rays);
    std::vector<std::optional<ProbeHit>> hits;
    for (const ProbeRay& ray : rays) hits.push_back(meshes_->closest(ray));
    return hits;
}

std::vector<std::optional<ProbeHit>> Surroundings::askGpu(std::span<const ProbeRay> rays) {
    std::vector<QueryRay> queries;
    for (const ProbeRay& ray : rays)
        queries.push_back(
            {ray.origin, std::min(kCone, 1e-3f * ray.length), ray.direction, ray.length});
    const std::vector<glm::uvec4> records = view_.stage.closest(queries);
    std::vector<std::optional<ProbeHit>> hits;
    const std::vector<PackedInstance>& instances = view_.moment().instances;
    for (size_t i = 0; i < rays.size(); ++i) {
        const glm::uvec4& record = records[i];
        if (!record::isSurface(record) || record.x >= instances.size()) {
            hits.emplace_back();
            continue;
        }
        const PackedInstance& instance = instances[record.x];
        glm::vec3 n = -rays[i].direction;
        if (instance.field) {
            n = record::unpackNormal(record.z);
            if (glm::dot(n, rays[i].direction) > 0) n = -n;
        } else if (record.y < instance.triangles) {
            n = normalOf(*instance.mesh->mesh, record.y, instance.worldFromObject,
                         rays[i].direction);
        }
        hits.push_back(ProbeHit{record::recordDistance(record), n});
    }
    return hits;
}

}  // namespace vitrine
