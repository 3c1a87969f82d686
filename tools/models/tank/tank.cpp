// SPDX-License-Identifier: MIT
#include "models/tank/tank.hpp"

#include <map>

#include "models/tank/chassis.hpp"
#include "models/tank/gun.hpp"
#include "models/tank/hull.hpp"
#include "models/tank/turret.hpp"

namespace vitrine::tank {
namespace {

/// Shares vertices between the corners that agree in everything.
class VertexPool {
  public:
    explicit VertexPool(Mesh& mesh) : mesh_(mesh) {}

    uint32_t add(const Corner& corner, const Vec2& uv) {
        const glm::vec3 p(corner.at), n(corner.normal);
        const glm::vec2 t(uv);
        const Key key{p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y};
        const auto [found, isNew] = numbers_.try_emplace(key, mesh_.positions.size());
        if (isNew) {
            mesh_.positions.push_back(p);
            mesh_.normals.push_back(n);
            mesh_.uvs.push_back(t);
        }
        return found->second;
    }

  private:
    using Key = std::array<float, 8>;
    Mesh& mesh_;
    std::map<Key, uint32_t> numbers_;
};

}  // namespace

std::vector<Assembly> makeTank(double drive) {
    return {makeChassis(drive), makeHull(), makeTurret(), makeGun()};
}

Mesh toMesh(const Assembly& assembly, const Atlas& atlas) {
    Mesh mesh;
    mesh.name = assembly.name;
    std::map<Material, uint32_t> numbers;
    for (const Part& part : assembly.parts)
        for (const Triangle& t : part.solid.triangles) numbers.emplace(t.material, 0);
    for (auto& [material, number] : numbers) {
        number = static_cast<uint32_t>(mesh.partNames.size());
        mesh.partNames.emplace_back(kMaterialNames[static_cast<size_t>(material)]);
    }
    VertexPool pool(mesh);
    for (size_t p = 0; p < assembly.parts.size(); ++p) {
        const Part& part = assembly.parts[p];
        for (const Mat4& place : part.places) {
            Solid copy;
            copy.append(part.solid, place);
            const bool mirrored = glm::determinant(place) < 0.0;
            for (size_t t = 0; t < copy.triangles.size(); ++t) {
                glm::uvec3 triangle;
                for (int k = 0; k < 3; ++k) {
                    // append() has swapped the last two corners of what it mirrored.
                    const int source = mirrored ? (3 - k) % 3 : k;
                    const Vec2 texel = atlas.corners[p][t][static_cast<size_t>(source)];
                    const Vec2 uv(texel.x / atlas.side, 1.0 - texel.y / atlas.side);
                    triangle[k] = pool.add(copy.triangles[t].corners[static_cast<size_t>(k)], uv);
                }
                mesh.triangles.push_back(triangle);
                mesh.triangleParts.push_back(numbers.at(copy.triangles[t].material));
            }
        }
    }
    return mesh;
}

}  // namespace vitrine::tank
