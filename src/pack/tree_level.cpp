// SPDX-License-Identifier: MIT
#include "pack/tree_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "bvh/level.hpp"

namespace vitrine {
namespace {

/// The nodes of a mesh's level, and the place of each triangle among them.
struct MeshLevel {
    std::vector<uint32_t> nodes;

    MeshLevel(const Bvh& bvh, int level, std::span<uint32_t> boxOfTriangle)
        : nodes(nodesOfLevel(bvh, level)) {
        // Backwards, so that the first of several wins.
        for (size_t i = nodes.size(); i-- > 0;) {
            const ItemRange items = itemsBelow(bvh, nodes[i]);
            for (uint32_t k = 0; k < items.count; ++k)
                boxOfTriangle[bvh.items[items.first + k]] = static_cast<uint32_t>(i);
        }
    }
};

/// Corner i of a box: bit 0 chooses x, bit 1 y, bit 2 z.
glm::vec3 cornerOf(const Aabb& box, int i) {
    return {(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
            (i & 4) != 0 ? box.max.z : box.min.z};
}

/// Corners of the six faces, counter-clockwise from outside: -x, +x, -y, +y, -z, +z.
constexpr std::array<std::array<int, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

void writeBox(std::string& out, const Aabb& box, const glm::mat4& worldFromObject, bool mirrored,
              size_t firstVertex) {
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 p(worldFromObject * glm::vec4(cornerOf(box, i), 1));
        fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p.x, p.y, p.z);
    }
    const glm::vec3 extent = box.extent();
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        // Faces without area: programs complain about them.
        if (extent[(axis + 1) % 3] <= 0 || extent[(axis + 2) % 3] <= 0) continue;
        out += 'f';
        for (int i = 0; i < 4; ++i) {
            const auto corner = static_cast<size_t>(
                kFaces[static_cast<size_t>(face)][static_cast<size_t>(mirrored ? 3 - i : i)]);
            fmt::format_to(std::back_inserter(out), " {}", firstVertex + corner);
        }
        out += '\n';
    }
}

}  // namespace

TreeLevel treeLevel(std::span<const PackedInstance> instances, int level) {
    TreeLevel result;
    size_t triangles = 0;
    for (const PackedInstance& instance : instances)
        triangles =
            std::max(triangles, static_cast<size_t>(instance.firstTriangle) + instance.triangles);
    result.boxOfTriangle.resize(triangles);
    std::map<const MeshAsset*, MeshLevel> meshes;
    for (size_t i = 0; i < instances.size(); ++i) {
        const PackedInstance& instance = instances[i];
        result.firstBox.push_back(static_cast<uint32_t>(result.boxes.size()));
        const auto number = static_cast<uint32_t>(i);
        if (instance.mesh == nullptr) {
            result.boxes.push_back({number, instance.objectBox, false});
            continue;
        }
        const Bvh& bvh = instance.mesh->bvh;
        auto known = meshes.find(instance.mesh.get());
        if (known == meshes.end()) {
            const std::span<uint32_t> places(result.boxOfTriangle.data() + instance.firstTriangle,
                                             instance.triangles);
            known = meshes.emplace(instance.mesh.get(), MeshLevel(bvh, level, places)).first;
        }
        for (const uint32_t node : known->second.nodes)
            result.boxes.push_back({number, bvh.nodes[node].box(), bvh.nodes[0].leaf()});
        if (result.boxes.size() > kMaxTreeBoxes)
            throw UsageError(
                fmt::format("level {} of the trees has more than {} boxes; ask for a "
                            "smaller one",
                            level, kMaxTreeBoxes));
    }
    result.firstBox.push_back(static_cast<uint32_t>(result.boxes.size()));
    return result;
}

std::string objOfTreeLevel(std::span<const PackedInstance> instances, const TreeLevel& level) {
    std::string out = "# Boxes of one level of the trees, world space, metres.\n";
    size_t firstVertex = 1;
    for (size_t i = 0; i < instances.size(); ++i) {
        const PackedInstance& instance = instances[i];
        // Names may repeat and hold blanks, which OBJ takes for the beginning of another name.
        std::string name = instance.name.empty() ? "instance" : instance.name;
        for (char& c : name)
            if (static_cast<unsigned char>(c) <= ' ' || c == '#' || c == '\\') c = '_';
        fmt::format_to(std::back_inserter(out), "o {}_{}\ng {}_{}\n", i, name, i, name);
        const bool mirrored = glm::determinant(glm::mat3(instance.worldFromObject)) < 0;
        for (uint32_t b = level.firstBox[i]; b < level.firstBox[i + 1]; ++b) {
            writeBox(out, level.boxes[b].box, instance.worldFromObject, mirrored, firstVertex);
            firstVertex += 8;
        }
    }
    return out;
}

}  // namespace vitrine
