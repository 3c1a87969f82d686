// SPDX-License-Identifier: MIT
#include "import/model_mesh.hpp"

#include "gltf/pose.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "gltf/read.hpp"
#include "mesh/primitives.hpp"
#include "mesh/tangents.hpp"

namespace vitrine {
namespace {

/// A model of one node with these meshes as its primitives' and one material each.
GltfModel modelOf(const std::vector<Mesh>& meshes) {
    GltfModel model;
    GltfMesh& mesh = model.meshes.emplace_back();
    mesh.name = "m";
    for (size_t i = 0; i < meshes.size(); ++i) {
        mesh.primitives.push_back({meshes[i], static_cast<int>(i)});
        model.materials.emplace_back().name = "material";
    }
    model.nodes.emplace_back().mesh = 0;
    model.nodeOrder = {0};
    model.scenes.push_back({"", {0}});
    return model;
}

/// Six times the enclosed volume; negative if the triangles look inwards.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
    return sum;
}

TEST(ModelMesh, PartsAreMaterials) {
    GltfModel model = modelOf({makeBox(glm::vec3(1)), makeSphere(1, 4), makePlane(1, 1)});
    model.meshes[0].primitives[2].material = 0;
    model.meshes[0].primitives.push_back({makePlane(2, 2), kNoIndex});
    const auto joined = joinMesh(model, model.meshes[0]);
    ASSERT_TRUE(joined);
    EXPECT_EQ(joined->materials, (std::vector<int>{0, 1, kNoIndex}));
    EXPECT_EQ(joined->mesh.partNames,
              (std::vector<std::string>{"material", "material#2", "default"}));
    size_t triangles = 0;
    for (const GltfPrimitive& p : model.meshes[0].primitives) {
        const uint32_t part = p.material == kNoIndex ? 2 : static_cast<uint32_t>(p.material);
        for (const glm::uvec3& t : p.mesh.triangles) {
            EXPECT_EQ(joined->mesh.triangleParts[triangles], part);
            for (int corner = 0; corner < 3; ++corner)
                EXPECT_EQ(joined->mesh.positions[joined->mesh.triangles[triangles][corner]],
                          p.mesh.positions[t[corner]]);
            ++triangles;
        }
    }
    EXPECT_EQ(joined->mesh.triangles.size(), triangles);
    EXPECT_TRUE(joined->mesh.uvs2.empty() && joined->mesh.colors.empty() &&
                joined->mesh.tangents.empty());
}

TEST(ModelMesh, KeepsOnlyWhatIsUsed) {
    std::vector<Mesh> meshes{makePlane(1, 1), makePlane(1, 1), makePlane(1, 1)};
    for (Mesh& mesh : meshes) {
        mesh.uvs2.assign(4, {0.25f, 0.75f});
        mesh.colors.assign(4, glm::vec4(1));
    }
    const auto plain = joinMesh(modelOf(meshes), modelOf(meshes).meshes[0]);
    EXPECT_TRUE(plain->mesh.uvs2.empty()) << "no texture lies on them";
    EXPECT_TRUE(plain->mesh.colors.empty()) << "white";
    EXPECT_TRUE(plain->mesh.tangents.empty()) << "no normal map";

    meshes[1].colors[2] = {1, 0, 0, 1};
    GltfModel model = modelOf(meshes);
    model.textures.emplace_back().image = 0;
    model.materials[1].occlusionTexture = {0, 1};
    model.materials[2].normalTexture.texture = 0;
    const Mesh mesh = joinMesh(model, model.meshes[0])->mesh;
    ASSERT_EQ(mesh.uvs2.size(), 12u);
    ASSERT_EQ(mesh.colors.size(), 12u);
    ASSERT_EQ(mesh.tangents.size(), 12u);
    for (size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(mesh.uvs2[i], i / 4 == 1 ? glm::vec2(0.25f, 0.75f) : glm::vec2(0)) << i;
        EXPECT_EQ(mesh.colors[i], i == 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(1)) << i;
        EXPECT_EQ(mesh.tangents[i], i / 4 == 2 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0)) << i;
    }
}

TEST(ModelMesh, TheFilesTangentsWin) {
    Mesh plane = makePlane(1, 1);
    plane.tangents.assign(4, {0, 0, 1, -1});
    GltfModel model = modelOf({plane});
    model.textures.emplace_back().image = 0;
    model.materials[0].normalTexture.texture = 0;
    const auto joined = joinMesh(model, model.meshes[0]);
    for (const glm::vec4& t : joined->mesh.tangents) EXPECT_EQ(t, glm::vec4(0, 0, 1, -1));
}

TEST(ModelMesh, TheWholeSceneStandsWhereItsNodesPutIt) {
    GltfModel model = modelOf({makeBox({1, 2, 3})});
    model.nodes.resize(3);
    model.nodes[0].mesh = kNoIndex;
    model.nodes[0].children = {1, 2};
    model.nodes[0].translation = {10, 0, 0};
    model.nodes[0].rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 1, 0));
    model.nodes[1].parent = model.nodes[2].parent = 0;
    model.nodes[1].mesh = model.nodes[2].mesh = 0;
    model.nodes[2].translation = {0, 5, 7};
    model.nodes[2].scale = {1, 1, -2};
    model.nodeOrder = {0, 1, 2};
    size_t skipped = 0;
    const auto joined = joinScene(model, skipped);
    ASSERT_TRUE(joined);
    EXPECT_EQ(skipped, 0u);
    EXPECT_EQ(sizeOfScene(model).triangles, 24u);
    const Mesh& mesh = joined->mesh;
    ASSERT_EQ(mesh.triangles.size(), 24u);
    // A quarter turn about y takes z to x: boxes of 6 x 4 x 2 about (10, 0, 0), and of twice the
    // depth about (17, 5, 0).
    const Aabb expected{{7, -2, -1}, {23, 7, 1}}, box = bounds(mesh),
                                                  asked = boundsOfScene(model, restPose(model));
    for (int axis = 0; axis < 3; ++axis)
        for (const Aabb& b : {box, asked}) {
            EXPECT_NEAR(b.min[axis], expected.min[axis], 1e-5f);
            EXPECT_NEAR(b.max[axis], expected.max[axis], 1e-5f);
        }
    EXPECT_NEAR(volume(mesh), 6 * (48 + 96), 1e-2) << "the mirrored one looks outwards, too";
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 flat = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                          mesh.positions[t.z] - mesh.positions[t.x]);
        EXPECT_NEAR(glm::dot(glm::normalize(flat), mesh.normals[t.x]), 1, 1e-5f);
    }
}

TEST(ModelMesh, MirroredTangentsKeepTheBitangentWhereVGrows) {
    Mesh plane = makePlane(1, 1);  // v grows towards -z
    GltfModel model = modelOf({plane});
    model.textures.emplace_back().image = 0;
    model.materials[0].normalTexture.texture = 0;
    model.nodes[0].scale = {-1, 1, 1};
    size_t skipped = 0;
    const Mesh mesh = joinScene(model, skipped)->mesh;
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(mesh.tangents[i], glm::vec4(-1, 0, 0, -1));
        const glm::vec3 b =
            glm::cross(mesh.normals[i], glm::vec3(mesh.tangents[i])) * mesh.tangents[i].w;
        EXPECT_EQ(b, glm::vec3(0, 0, -1));
    }
}

/// Tangents that an artist's program wrote, against ours for the same mesh.
TEST(ModelMesh, GeneratedTangentsAreThoseOfARealFile) {
    const char* data = std::getenv("VITRINE_TEST_DATA");
    if (data == nullptr) GTEST_SKIP() << "VITRINE_TEST_DATA is not set";
    const auto file = std::filesystem::path(data) / "FlightHelmet/FlightHelmet.gltf";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "it has no FlightHelmet";
    Diagnostics diagnostics;
    const auto model = readGltf(file, diagnostics);
    ASSERT_TRUE(model) << diagnostics.text();
    size_t corners = 0, near = 0, sameSide = 0;
    for (const GltfMesh& mesh : model->meshes)
        for (const GltfPrimitive& primitive : mesh.primitives) {
            Mesh ours = primitive.mesh;
            generateTangents(ours, false);
            for (size_t t = 0; t < ours.triangles.size(); ++t)
                for (int corner = 0; corner < 3; ++corner) {
                    const glm::vec4& a = ours.tangents[ours.triangles[t][corner]];
                    const glm::vec4& b =
                        primitive.mesh.tangents[primitive.mesh.triangles[t][corner]];
                    ++corners;
                    near += glm::dot(glm::vec3(a), glm::vec3(b)) > 0.98f ? 1 : 0;
                    sameSide += a.w == b.w ? 1 : 0;
                }
        }
    EXPECT_GT(static_cast<double>(near) / static_cast<double>(corners), 0.95);
    EXPECT_GT(static_cast<double>(sameSide) / static_cast<double>(corners), 0.99);
}

TEST(ModelMesh, WhatCannotBePlacedIsLeftOut) {
    GltfModel model = modelOf({makeBox(glm::vec3(1))});
    for (const float scale : {1e-30f, 1e25f}) {
        model.nodes[0].scale = glm::vec3(scale);
        size_t skipped = 0;
        EXPECT_FALSE(joinScene(model, skipped));
        EXPECT_EQ(skipped, 1u) << scale;
        EXPECT_TRUE(boundsOfScene(model, restPose(model)).empty());
    }
    model.nodes[0].scale = glm::vec3(1);
    model.meshes[0].primitives.clear();
    EXPECT_FALSE(joinMesh(model, model.meshes[0]));
}

}  // namespace
}  // namespace vitrine
