// SPDX-License-Identifier: MIT
#include "frame/raster_order.hpp"

namespace vitrine {
namespace {

void append(std::vector<RasterRange>& ranges, uint32_t first, uint32_t count) {
    if (count == 0) return;
    if (!ranges.empty() && ranges.back().first + ranges.back().count == first)
        ranges.back().count += count;
    else
        ranges.push_back({first, count});
}

}  // namespace

bool RasterOrder::add(std::span<const PackedInstance> instances) {
    const size_t before = indices_.size();
    for (const PackedInstance& instance : instances) {
        if (instance.mesh == nullptr || meshes_.count(instance.mesh) != 0) continue;
        Shells found = findShells(*instance.mesh->mesh);
        meshes_.emplace(instance.mesh,
                        Known{std::move(found.shells), static_cast<uint32_t>(indices_.size()),
                              static_cast<uint32_t>(found.order.size())});
        for (const uint32_t triangle : found.order)
            for (uint32_t corner = 0; corner < 3; ++corner)
                indices_.push_back(3 * triangle + corner);
    }
    return indices_.size() != before;
}

RasterOrder::Ranges RasterOrder::ranges(const PackedInstance& instance,
                                        const glm::vec3& eye) const {
    const Known& known = meshes_.at(instance.mesh);
    Ranges result;
    const uint32_t end = known.firstIndex + 3 * known.triangles;
    if (instance.culled) {
        append(result.culled, known.firstIndex, end - known.firstIndex);
        return result;
    }
    uint32_t next = known.firstIndex;
    if (!instance.filtered) {  // else backs are seen through fronts
        const glm::vec3 local(glm::inverse(instance.worldFromObject) * glm::vec4(eye, 1));
        for (const Shell& shell : known.shells) {
            append(shell.hidesBacks(local) ? result.culled : result.whole, next, 3 * shell.count);
            next += 3 * shell.count;
        }
    }
    append(result.whole, next, end - next);
    return result;
}

}  // namespace vitrine
