// SPDX-License-Identifier: MIT
// Models that people made, if the environment variable VITRINE_TEST_DATA names a folder with them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "gltf/pose.hpp"
#include "gltf/read.hpp"

namespace vitrine {
namespace {

class GltfRealModels : public testing::Test {
  protected:
    /// Empty, after skipping the test, if the file is not there.
    std::optional<GltfModel> read(const std::string& name, const std::string& expectedMessages) {
        const char* data = std::getenv("VITRINE_TEST_DATA");
        if (data == nullptr) return {};
        const std::filesystem::path file = std::filesystem::path(data) / name;
        if (!std::filesystem::exists(file)) return {};
        Diagnostics diagnostics;
        auto model = readGltf(file, diagnostics);
        const std::string prefix = file.string() + ": ";
        std::string messages = diagnostics.text();
        if (messages.starts_with(prefix)) messages.erase(0, prefix.size());
        EXPECT_EQ(messages, expectedMessages);
        EXPECT_TRUE(model);
        return model;
    }
    static size_t triangles(const GltfModel& model) {
        size_t count = 0;
        for (const GltfMesh& mesh : model.meshes)
            for (const GltfPrimitive& p : mesh.primitives) count += p.mesh.triangles.size();
        return count;
    }
    static void expectPicturesDecode(const GltfModel& model) {
        Diagnostics diagnostics;
        for (const GltfImage& image : model.images)
            EXPECT_EQ(decodeGltfImage(image, image.name, diagnostics).width, image.width);
        EXPECT_EQ(diagnostics.text(), "");
    }
};

/// Do the tangents of a mesh, with our direction of v, agree with its positions and uvs?
double shareOfGoodBitangents(const Mesh& mesh) {
    size_t good = 0, all = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 edge1 = mesh.positions[t.y] - mesh.positions[t.x];
        const glm::vec3 edge2 = mesh.positions[t.z] - mesh.positions[t.x];
        const glm::vec2 uv1 = mesh.uvs[t.y] - mesh.uvs[t.x], uv2 = mesh.uvs[t.z] - mesh.uvs[t.x];
        const float area = uv1.x * uv2.y - uv2.x * uv1.y;
        if (area == 0) continue;
        const glm::vec3 whereVGrows = (uv1.x * edge2 - uv2.x * edge1) / area;
        const glm::vec4& tangent = mesh.tangents[t.x];
        const glm::vec3 bitangent = glm::cross(mesh.normals[t.x], glm::vec3(tangent)) * tangent.w;
        good += glm::dot(bitangent, whereVGrows) > 0;
        ++all;
    }
    return double(good) / double(all);
}

TEST_F(GltfRealModels, FlightHelmet) {
    const auto model = read("FlightHelmet/FlightHelmet.gltf", "");
    if (!model) GTEST_SKIP();
    EXPECT_EQ(triangles(*model), 94722u);
    EXPECT_EQ(model->materials.size(), 6u);
    EXPECT_EQ(model->images.size(), 15u);
    EXPECT_EQ(nodesOfScene(*model, model->scene).size(), 6u);
    EXPECT_EQ(model->materials[5].alphaMode, GltfAlphaMode::kBlend);
    for (const GltfMesh& mesh : model->meshes)
        EXPECT_GT(shareOfGoodBitangents(mesh.primitives.at(0).mesh), 0.99) << mesh.name;
    expectPicturesDecode(*model);
}

TEST_F(GltfRealModels, ToyCar) {
    const auto model =
        read("ToyCar/ToyCar.glb", "warning: /meshes/0/primitives/0: 2 triangles dropped: no area");
    if (!model) GTEST_SKIP();
    EXPECT_EQ(triangles(*model), 108934u);
    EXPECT_EQ(model->cameras.size(), 8u);
    EXPECT_EQ(model->materials[0].clearcoatFactor, 1);
    EXPECT_EQ(model->materials[1].sheenColorFactor, glm::vec3(1, 0, 0));
    EXPECT_EQ(model->materials[1].baseColorTexture.scale, glm::vec2(3));
    EXPECT_EQ(model->materials[2].transmissionFactor, 1);
    expectPicturesDecode(*model);
}

}  // namespace
}  // namespace vitrine
