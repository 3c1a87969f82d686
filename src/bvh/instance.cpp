// SPDX-License-Identifier: MIT
#include "bvh/instance.hpp"

#include <array>
#include <cassert>

#include "bvh/build.hpp"
#include "bvh/slab.hpp"

namespace vitrine {

Aabb instanceBox(const Aabb& meshBox, const glm::mat4& worldFromObject) {
    Aabb box = meshBox.transformed(worldFromObject);
    if (box.empty()) return box;
    constexpr float kRelative = 1e-5f;
    const glm::vec3 reach = glm::max(glm::abs(box.min), glm::abs(box.max));
    const glm::vec3 margin(kRelative * glm::max(reach.x, glm::max(reach.y, reach.z)));
    return {box.min - margin, box.max + margin};
}

Ray transformed(const Ray& ray, const glm::mat4& objectFromWorld) {
    return {glm::vec3(objectFromWorld * glm::vec4(ray.origin, 1)),
            glm::mat3(objectFromWorld) * ray.direction, ray.tMin, ray.tMax};
}

Bvh buildInstanceBvh(std::span<const Instance> instances, std::span<const MeshView> meshes) {
    std::vector<Aabb> boxes;
    boxes.reserve(instances.size());
    for (const Instance& instance : instances) {
        const Aabb meshBox = meshes[instance.mesh].bvh->box();
        const glm::vec3 origin(instance.worldFromObject[3]);
        boxes.push_back(meshBox.empty() ? Aabb{origin, origin}
                                        : instanceBox(meshBox, instance.worldFromObject));
    }
    return buildBvh(boxes, {.maxLeafSize = 1});
}

std::optional<SceneHit> sceneClosestHit(const Bvh& instanceBvh, std::span<const Instance> instances,
                                        std::span<const MeshView> meshes, const Ray& ray,
                                        TraversalCounters* counters) {
    std::optional<SceneHit> result;
    if (instanceBvh.empty()) return result;
    const SlabTest slabs(ray, instanceBvh.box());
    Ray remaining = ray;

    std::array<uint32_t, 64> stack;
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const BvhNode& node = instanceBvh.nodes[stack[--size]];
        if (counters) ++counters->nodes;
        const Interval box = slabs(node.min, node.max);
        if (box.empty() || box.min > remaining.tMax || box.max < remaining.tMin) continue;
        if (!node.leaf()) {
            assert(size + 2 <= int(stack.size()));
            stack[size++] = node.first;
            stack[size++] = node.first + 1;
            continue;
        }
        for (uint32_t i = 0; i < node.count; ++i) {
            const uint32_t number = instanceBvh.items[node.first + i];
            const Instance& instance = instances[number];
            const MeshView& mesh = meshes[instance.mesh];
            const Ray local = transformed(remaining, glm::inverse(instance.worldFromObject));
            const auto hit = closestHit(*mesh.bvh, mesh.positions, mesh.triangles, local, counters);
            if (!hit) continue;
            if (result && hit->t == result->hit.t && number > result->instance) continue;
            result = SceneHit{*hit, number};
            remaining.tMax = hit->t;
        }
    }
    return result;
}

}  // namespace vitrine
