// SPDX-License-Identifier: MIT
#include "models/tank/tank.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/textures.hpp"

namespace vitrine::tank {
namespace {

constexpr int kSide = 512;  // of the textures here, for speed

struct Built {
    std::vector<Assembly> assemblies = makeTank();
    std::vector<Atlas> atlases;
    std::vector<Mesh> meshes;

    Built() {
        for (const Assembly& assembly : assemblies) {
            atlases.push_back(unwrap(assembly, kSide));
            meshes.push_back(toMesh(assembly, atlases.back()));
        }
    }
};

const Built& built() {
    static const Built tank;
    return tank;
}

TEST(Tank, HasFourMeshesWithinTheBudget) {
    std::vector<std::string> names;
    size_t triangles = 0;
    for (const Mesh& mesh : built().meshes) {
        names.push_back(mesh.name);
        triangles += mesh.triangles.size();
        EXPECT_FALSE(mesh.partNames.empty());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"chassis", "hull", "turret", "gun"}));
    EXPECT_GE(triangles, 60000u);
    EXPECT_LE(triangles, 66000u);
}

TEST(Tank, HasTheSizeOfATank) {
    Aabb box;
    for (size_t i = 0; i < 2; ++i) {
        const Aabb each = bounds(built().meshes[i]);
        box.min = glm::min(box.min, each.min);
        box.max = glm::max(box.max, each.max);
    }
    EXPECT_NEAR(box.extent().x, 6.9f, 0.15f);
    EXPECT_NEAR(box.extent().z, 3.4f, 0.1f);
    EXPECT_NEAR(box.min.y, 0.0f, 1e-4f);
    EXPECT_EQ(built().assemblies[2].origin, kTurretInHull);
    EXPECT_EQ(built().assemblies[3].origin, kTurretInHull + kGunInTurret);
}

TEST(Tank, NothingIsDegenerate) {
    for (const Mesh& mesh : built().meshes) {
        Mesh copy = mesh;
        Diagnostics diagnostics;
        sanitizeMesh(copy, {}, diagnostics);
        EXPECT_EQ(diagnostics.text(), "") << mesh.name;
        EXPECT_EQ(copy.triangles.size(), mesh.triangles.size()) << mesh.name;
    }
}

TEST(Tank, NormalsFitTheTriangles) {
    for (const Mesh& mesh : built().meshes)
        for (const glm::uvec3& v : mesh.triangles) {
            const glm::vec3 a = mesh.positions[v.x];
            const glm::vec3 flat =
                glm::normalize(glm::cross(mesh.positions[v.y] - a, mesh.positions[v.z] - a));
            for (int k = 0; k < 3; ++k)
                // Least where three plates meet in a point under the front corners.
                ASSERT_GT(glm::dot(mesh.normals[v[k]], flat), 0.08f)
                    << mesh.name << " at " << a.x << " " << a.y << " " << a.z;
        }
}

TEST(Tank, TextureCoordinatesStayInTheSquare) {
    for (const Mesh& mesh : built().meshes)
        for (const glm::vec2& uv : mesh.uvs) {
            ASSERT_GE(std::min(uv.x, uv.y), 0.0f) << mesh.name;
            ASSERT_LE(std::max(uv.x, uv.y), 1.0f) << mesh.name;
        }
}

TEST(Tank, ChartsDoNotOverlap) {
    for (const Atlas& atlas : built().atlases) {
        // How often each texel's centre is inside of a triangle; common edges count for one side.
        std::vector<int> hits(kSide * kSide, 0);
        for (const auto& part : atlas.corners)
            for (const auto& t : part) {
                const Vec2 low = glm::min(glm::min(t[0], t[1]), t[2]),
                           high = glm::max(glm::max(t[0], t[1]), t[2]);
                for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
                    for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x) {
                        const Vec2 p(x + 0.50123, y + 0.50321);
                        int sides = 0;
                        for (size_t k = 0; k < 3; ++k) {
                            const Vec2 e = t[(k + 1) % 3] - t[k], d = p - t[k];
                            sides += e.x * d.y - e.y * d.x > 0.0 ? 1 : -1;
                        }
                        if (std::abs(sides) == 3) ++hits[static_cast<size_t>(y * kSide + x)];
                    }
            }
        int twice = 0, once = 0;
        for (const int count : hits) {
            once += count > 0 ? 1 : 0;
            twice += count > 1 ? 1 : 0;
        }
        EXPECT_LT(twice, once / 200);
        EXPECT_GT(once, kSide * kSide / 3);
    }
}

TEST(Tank, DrivingMovesPlacesOnly) {
    const std::vector<Assembly> driven = makeTank(0.37);
    for (size_t i = 0; i < driven.size(); ++i) {
        ASSERT_EQ(driven[i].parts.size(), built().assemblies[i].parts.size());
        for (size_t p = 0; p < driven[i].parts.size(); ++p) {
            EXPECT_EQ(driven[i].parts[p].solid.triangles.size(),
                      built().assemblies[i].parts[p].solid.triangles.size());
            EXPECT_EQ(driven[i].parts[p].places.size(),
                      built().assemblies[i].parts[p].places.size());
        }
    }
}

struct Mean {
    double r = 0, g = 0, b = 0;

    explicit Mean(const ImageRgba8& image) {
        const double share = 1.0 / (255.0 * double(image.pixelCount()));
        for (size_t i = 0; i < image.pixels.size(); i += 4) {
            r += share * image.pixels[i];
            g += share * image.pixels[i + 1];
            b += share * image.pixels[i + 2];
        }
    }
};

TEST(Tank, TexturesAreSaneAndTheSameEveryTime) {
    const Occluder occluder = makeOccluder(built().assemblies);
    const Assembly& gun = built().assemblies[3];
    const Atlas atlas = unwrap(gun, 256);
    const Textures textures = makeTextures(gun, atlas, occluder);
    const Mean albedo(textures.albedo), normal(textures.normal), orm(textures.orm),
        old(textures.glossMetal);
    EXPECT_GT(albedo.g, 0.15);
    EXPECT_LT(albedo.g, 0.50);
    EXPECT_GT(albedo.r, albedo.b);
    EXPECT_NEAR(normal.r, 0.5, 0.03);
    EXPECT_NEAR(normal.g, 0.5, 0.03);
    EXPECT_GT(normal.b, 0.93);
    EXPECT_GT(orm.r, 0.35);
    EXPECT_LT(orm.r, 0.95);
    EXPECT_GT(orm.g, 0.45);
    EXPECT_LT(orm.g, 0.85);
    EXPECT_LT(orm.b, 0.30);
    EXPECT_NEAR(old.r, 1.0 - orm.g, 0.01);
    EXPECT_NEAR(old.g, orm.b, 0.01);

    const Textures again = makeTextures(gun, atlas, occluder);
    EXPECT_EQ(again.albedo, textures.albedo);
    EXPECT_EQ(again.normal, textures.normal);
    EXPECT_EQ(again.orm, textures.orm);
}

}  // namespace
}  // namespace vitrine::tank
