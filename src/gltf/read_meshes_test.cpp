// SPDX-License-Identifier: MIT
#include "gltf/test_model.hpp"
#include "gltf/triangle_indices.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;
using GltfMeshes = GltfTest;
using Corners = std::vector<glm::uvec3>;

const Mesh& onlyMesh(const GltfModel& model) {
    static const Mesh kNone;
    if (model.meshes.size() == 1 && model.meshes[0].primitives.size() == 1)
        return model.meshes[0].primitives[0].mesh;
    ADD_FAILURE() << "not exactly one primitive";
    return kNone;
}

Json& attributes(TestModel& model) {
    return model.json["meshes"][0]["primitives"][0]["attributes"];
}

TEST_F(GltfMeshes, ReadsIndexedTriangles) {
    TestModel model = square();
    model.json["meshes"][0]["name"] = "sheet";
    const GltfModel read = readGood(model);
    const Mesh& mesh = onlyMesh(read);
    EXPECT_EQ(mesh.name, "sheet");
    EXPECT_EQ(mesh.triangles, (Corners{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.positions[2], glm::vec3(1, 1, 0));
    EXPECT_EQ(mesh.normals[3], glm::vec3(0, 0, 1)) << "missing normals are generated";
    EXPECT_EQ(read.meshes[0].primitives[0].material, kNoIndex);
    EXPECT_TRUE(mesh.uvs2.empty() && mesh.colors.empty() && mesh.tangents.empty());
}

TEST_F(GltfMeshes, ReadsTheSameFromGltfAndGlb) {
    for (const int indent : {-1, 2}) {
        const auto model = read(square().gltf(indent), "m.gltf");
        EXPECT_EQ(messages, "");
        ASSERT_TRUE(model);
        EXPECT_EQ(onlyMesh(*model).triangles.size(), 2u);
    }
    TestModel apart = square();
    apart.json["buffers"] = {{{"byteLength", apart.binary.size()}, {"uri", "a%20b.bin"}}};
    write("a b.bin", apart.binary);
    ASSERT_TRUE(read(apart.gltf(), "m.gltf")) << messages;
}

TEST_F(GltfMeshes, ReadsStripsFansAndListsWithoutIndices) {
    TestModel model = square();
    Json& primitive = model.json["meshes"][0]["primitives"][0];
    primitive.erase("indices");
    primitive["mode"] = 6;
    EXPECT_EQ(onlyMesh(readGood(model)).triangles, (Corners{{1, 2, 0}, {2, 3, 0}}));
    primitive["indices"] =
        model.addAccessor<uint8_t>({0, 1, 3, 2, 2, 2}, "SCALAR", 6);  // with stitches at its end
    primitive["mode"] = 5;
    EXPECT_EQ(onlyMesh(readGood(model)).triangles, (Corners{{0, 1, 3}, {1, 2, 3}}));
    primitive.erase("indices");
    primitive["mode"] = 4;
    ASSERT_TRUE(read(model.glb()));
    EXPECT_EQ(
        messages,
        "m.glb: warning: /meshes/0/primitives/0: 4 corners are not a multiple of 3; the last 1 "
        "left out");
}

TEST(GltfTriangles, AllOfAStripWindTheSameWay) {
    EXPECT_EQ(toTriangles(PrimitiveMode::kTriangleStrip, {0, 1, 2, 3, 4}),
              (Corners{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    EXPECT_EQ(toTriangles(PrimitiveMode::kTriangleFan, {0, 1, 2, 3}),
              (Corners{{1, 2, 0}, {2, 3, 0}}));
    EXPECT_EQ(triangleCount(PrimitiveMode::kTriangles, 8), 2u);
    EXPECT_EQ(triangleCount(PrimitiveMode::kTriangleStrip, 2), 0u);
}

TEST_F(GltfMeshes, TakesOnlyTheVerticesThatItUses) {
    TestModel model;
    std::vector<float> positions(3000, 7.0f);
    for (const auto& [vertex, x, y] : {std::tuple(500, 0, 0), {501, 1, 0}, {502, 0, 1}}) {
        positions[vertex * 3] = static_cast<float>(x);
        positions[vertex * 3 + 1] = static_cast<float>(y);
    }
    model.addAccessor(positions, "VEC3", 1000);
    model.addAccessor<uint32_t>({502, 500, 501}, "SCALAR", 3);
    model.add("meshes", Json::parse(R"({"primitives": [
        {"attributes": {"POSITION": 0}, "indices": 1}]})"));
    GltfLimits limits;
    limits.vertices = 3;
    const auto result = read(model.glb(), "m.glb", limits);
    ASSERT_TRUE(result) << messages;
    EXPECT_EQ(onlyMesh(*result).triangles, (Corners{{2, 0, 1}}));
    ASSERT_EQ(onlyMesh(*result).positions.size(), 3u);
    EXPECT_EQ(onlyMesh(*result).positions[1], glm::vec3(1, 0, 7));
}

TEST_F(GltfMeshes, ReadsEveryAttribute) {
    TestModel model = square();
    Json& a = attributes(model);
    a["NORMAL"] = model.addAccessor<float>({0, 0, 2, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 4);
    a["TANGENT"] =
        model.addAccessor<float>({1, 0, 0, 1, 2, 0, 0, -1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4);
    a["TEXCOORD_0"] = model.addAccessor<float>({0, 1, 1, 1, 1, 0, 0.25f, 0.25f}, "VEC2", 4);
    a["TEXCOORD_1"] = model.addAccessor<uint8_t>({0, 0, 255, 0, 0, 255, 51, 51}, "VEC2", 4,
                                                 {{"normalized", true}});
    a["COLOR_0"] = model.addAccessor<uint16_t>({65535, 0, 0, 0, 13107, 0, 0, 0, 0, 0, 0, 0}, "VEC3",
                                               4, {{"normalized", true}});
    const GltfModel read = readGood(model);
    const Mesh& mesh = onlyMesh(read);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.tangents[1], glm::vec4(1, 0, 0, -1));
    EXPECT_EQ(mesh.uvs[0], glm::vec2(0, 0)) << "upper left becomes lower left";
    EXPECT_EQ(mesh.uvs[3], glm::vec2(0.25f, 0.75f));
    EXPECT_EQ(mesh.uvs2[1], glm::vec2(1, 1));
    EXPECT_NEAR(mesh.uvs2[3].y, 0.8f, 1e-6f);
    EXPECT_EQ(mesh.colors[0], glm::vec4(1, 0, 0, 1)) << "three components mean opaque";
    EXPECT_NEAR(mesh.colors[1].y, 0.2f, 1e-6f);
}

TEST_F(GltfMeshes, TangentsWithoutNormalsAreIgnored) {
    TestModel model = square();
    attributes(model)["TANGENT"] = model.addAccessor<float>(std::vector<float>(16, 1), "VEC4", 4);
    EXPECT_TRUE(onlyMesh(readGood(model)).tangents.empty());
}

TEST_F(GltfMeshes, ReadsInterleavedVertices) {
    TestModel model = square();
    std::vector<float> rows;
    for (const glm::vec2 p : {glm::vec2(0, 0), {4, 0}, {4, 4}, {0, 4}})
        rows.insert(rows.end(), {p.x, p.y, 1, p.x / 4, p.y / 4});
    const size_t view = model.addView(rows, 20);
    attributes(model)["POSITION"] =
        model.add("accessors",
                  {{"bufferView", view}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 4}});
    attributes(model)["TEXCOORD_0"] = model.add("accessors", {{"bufferView", view},
                                                              {"byteOffset", 12},
                                                              {"componentType", 5126},
                                                              {"type", "VEC2"},
                                                              {"count", 4}});
    const GltfModel read = readGood(model);
    EXPECT_EQ(onlyMesh(read).positions[2], glm::vec3(4, 4, 1));
    EXPECT_EQ(onlyMesh(read).uvs[2], glm::vec2(1, 0));
}

TEST_F(GltfMeshes, ReadsQuantizedVertices) {
    TestModel model = square();
    attributes(model)["POSITION"] =
        model.add("accessors",
                  {{"bufferView",
                    model.addView<int16_t>(
                        {0, 0, 0, 0, 32767, 0, 0, 0, 32767, 32767, 0, 0, -32768, 32767, 0, 0}, 8)},
                   {"componentType", 5122},
                   {"type", "VEC3"},
                   {"count", 4},
                   {"normalized", true}});
    attributes(model)["NORMAL"] = model.add(
        "accessors",
        {{"bufferView",
          model.addView<int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}, 4)},
         {"componentType", 5120},
         {"type", "VEC3"},
         {"count", 4},
         {"normalized", true}});
    attributes(model)["TEXCOORD_0"] =
        model.addAccessor<int16_t>({0, 0, 3, 0, 3, -3, 0, 3}, "VEC2", 4);
    EXPECT_FALSE(read(model.glb()));
    EXPECT_NE(messages.find("/meshes/0/primitives/0/attributes/POSITION: the accessor's type needs "
                            "the extension KHR_mesh_quantization"),
              std::string::npos)
        << messages;
    model.json["extensionsRequired"] = model.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    const GltfModel good = readGood(model);
    EXPECT_EQ(onlyMesh(good).positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(onlyMesh(good).positions[3], glm::vec3(-1, 1, 0));
    EXPECT_EQ(onlyMesh(good).normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(onlyMesh(good).uvs[2], glm::vec2(3, 4));
}

TEST_F(GltfMeshes, ReadsSparseAccessors) {
    TestModel model = square();
    Json sparse{{"count", 2}};
    sparse["indices"] = {{"bufferView", model.addView<uint8_t>({1, 3})}, {"componentType", 5121}};
    sparse["values"] = {{"bufferView", model.addView<float>({5, 0, 0, 0, 6, 0})}};
    model.json["accessors"][0]["sparse"] = sparse;
    const GltfModel read = readGood(model);
    EXPECT_EQ(onlyMesh(read).positions[0], glm::vec3(0, 0, 0));
    EXPECT_EQ(onlyMesh(read).positions[1], glm::vec3(5, 0, 0));
    EXPECT_EQ(onlyMesh(read).positions[2], glm::vec3(1, 1, 0));
    EXPECT_EQ(onlyMesh(read).positions[3], glm::vec3(0, 6, 0));

    // Without a bufferView all that is not replaced is zero; then the first triangle has no area.
    // The other one's second corner is replaced too.
    model.json["accessors"][0].erase("bufferView");
    Json onIndices{{"count", 1}};
    onIndices["indices"] = {{"bufferView", model.addView<uint32_t>({4})}, {"componentType", 5125}};
    onIndices["values"] = {{"bufferView", model.addView<uint16_t>({1})}};
    model.json["accessors"][1]["sparse"] = onIndices;
    const auto zeros = this->read(model.glb());
    EXPECT_EQ(messages, "m.glb: warning: /meshes/0/primitives/0: 1 triangle dropped: no area");
    ASSERT_TRUE(zeros);
    EXPECT_EQ(onlyMesh(*zeros).positions,
              (std::vector<glm::vec3>{{0, 0, 0}, {5, 0, 0}, {0, 6, 0}}));
}

TEST_F(GltfMeshes, ReplacedElementsBeforeTheUsedRangeAreSkipped) {
    TestModel model = square();
    model.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", model.addView<uint8_t>({0, 3})}, {"componentType", 5121}}},
        {"values", {{"bufferView", model.addView<float>({9, 9, 9, 0, 6, 0})}}}};
    model.json["meshes"][0]["primitives"][0]["indices"] =
        model.addAccessor<uint8_t>({1, 2, 3}, "SCALAR", 3);
    const GltfModel read = readGood(model);
    EXPECT_EQ(onlyMesh(read).positions, (std::vector<glm::vec3>{{1, 0, 0}, {1, 1, 0}, {0, 6, 0}}));
}

TEST_F(GltfMeshes, LyingBoundsAreHarmless) {
    TestModel model = square();
    model.json["accessors"][0]["min"] = {5, 5, 5};
    model.json["accessors"][0]["max"] = {-5, "x", nullptr};
    EXPECT_EQ(bounds(onlyMesh(readGood(model))).max, glm::vec3(1, 1, 0));
}

TEST_F(GltfMeshes, WhatIsNotSupportedIsLeftOutWithOneWarning) {
    TestModel model = square();
    Json& primitives = model.json["meshes"][0]["primitives"];
    const Json original = primitives[0];
    for (const int mode : {0, 1, 2, 3, 4}) {
        primitives.push_back(original);
        primitives.back()["mode"] = mode;
    }
    primitives[0]["targets"] = {{{"POSITION", 0}}};
    primitives.push_back({{"attributes", {{"NORMAL", 0}}}});
    const auto result = read(model.glb());
    EXPECT_EQ(
        messages,
        "m.glb: warning: /meshes/0/primitives/0: morph targets are not supported; meshes keep "
        "their own shape\n"
        "m.glb: warning: /meshes/0/primitives/1: points and lines are not supported; left out\n"
        "m.glb: warning: /meshes/0/primitives/6: left out: it has no positions");
    ASSERT_TRUE(result);
    EXPECT_EQ(result->meshes[0].primitives.size(), 2u);
}

TEST_F(GltfMeshes, BadNumbersAreDroppedWithOneCountedWarning) {
    TestModel model;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    model.addAccessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, nan, 1, 0, 0, 3e38f, 0}, "VEC3", 5);
    model.addAccessor<uint16_t>({0, 1, 2, 0, 2, 3, 0, 1, 4, 0, 0, 1}, "SCALAR", 12);
    model.add("meshes", Json::parse(R"({"primitives": [
        {"attributes": {"POSITION": 0}, "indices": 1}]})"));
    const auto result = read(model.glb());
    EXPECT_EQ(messages,
              "m.glb: warning: /meshes/0/primitives/0: 2 triangles dropped: infinite, huge or "
              "not-a-number coordinates\n"
              "m.glb: warning: /meshes/0/primitives/0: 1 triangle dropped: no area");
    ASSERT_TRUE(result);
    EXPECT_EQ(onlyMesh(*result).triangles.size(), 1u);
    model.json["accessors"][1]["count"] = 3;
    model.json["accessors"][1]["byteOffset"] = 6;
    const auto empty = read(model.glb());
    EXPECT_NE(messages.find("left out: the mesh has no usable triangle left"), std::string::npos);
    ASSERT_TRUE(empty);
    EXPECT_TRUE(empty->meshes[0].primitives.empty());
}

}  // namespace
}  // namespace vitrine
