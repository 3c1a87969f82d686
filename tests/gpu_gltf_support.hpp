// SPDX-License-Identifier: MIT
// Pictures of glTF models against pictures of the same things made in another way. Pictures are
// equal if at most 0.1 % of their pixels are off by more than 5 of 255: transforms are multiplied
// in another order, which moves edges by rounding errors.
#pragma once

#include "gltf/test_model.hpp"
#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "import/import_models.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {

using nlohmann::json;

inline constexpr const char* kStage = R"([render]
ao = 0
tone_map = "none"
bounces = 0
[[camera]]
eye = [1.5, 2, 4]
target = [0, 0, 0]
fov = 40
[environment]
sky = [0.1, 0.15, 0.2]
[[light]]
direction = [-0.6, -1, -0.5]
intensity = 2
)";

/// Random colours, or normals that lean up to 35 degrees.
inline ImageRgba8 randomPicture(bool normals, int size = 16) {
    std::mt19937 random(7);
    ImageRgba8 image(size, size);
    for (size_t i = 0; i < image.pixels.size(); i += 4) {
        const glm::vec3 n = glm::normalize(
            glm::vec3(test::uniform(random, -0.5f, 0.5f), test::uniform(random, -0.5f, 0.5f), 1));
        for (size_t c = 0; c < 3; ++c)
            image.pixels[i + c] = normals
                                      ? static_cast<uint8_t>(127.5f * n[static_cast<int>(c)] + 128)
                                      : static_cast<uint8_t>(40 + random() % 180);
        image.pixels[i + 3] = 255;
    }
    return image;
}

inline size_t addMesh(TestModel& model, const Mesh& mesh, const json& more = json::object()) {
    std::vector<float> positions, normals, uvs, uvs2, colors, tangents;
    std::vector<uint32_t> indices;
    const auto append = [](std::vector<float>& to, const auto& v) {
        for (int i = 0; i < v.length(); ++i) to.push_back(v[i]);
    };
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        append(positions, mesh.positions[i]);
        append(normals, mesh.normals[i]);
        append(uvs, glm::vec2(mesh.uvs[i].x, 1 - mesh.uvs[i].y));
        if (!mesh.uvs2.empty()) append(uvs2, glm::vec2(mesh.uvs2[i].x, 1 - mesh.uvs2[i].y));
        if (!mesh.colors.empty()) append(colors, mesh.colors[i]);
        if (!mesh.tangents.empty()) append(tangents, mesh.tangents[i]);
    }
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) indices.push_back(t[corner]);
    const size_t count = mesh.positions.size();
    json primitive = more;
    json& attributes = primitive["attributes"];
    attributes["POSITION"] = model.addAccessor(positions, "VEC3", count);
    attributes["NORMAL"] = model.addAccessor(normals, "VEC3", count);
    attributes["TEXCOORD_0"] = model.addAccessor(uvs, "VEC2", count);
    if (!uvs2.empty()) attributes["TEXCOORD_1"] = model.addAccessor(uvs2, "VEC2", count);
    if (!colors.empty()) attributes["COLOR_0"] = model.addAccessor(colors, "VEC4", count);
    if (!tangents.empty()) attributes["TANGENT"] = model.addAccessor(tangents, "VEC4", count);
    primitive["indices"] = model.addAccessor(indices, "SCALAR", indices.size());
    return model.add("meshes", {{"primitives", {primitive}}});
}

/// Texture 0 is random colours, texture 1 random normals.
inline void addTextures(TestModel& model) {
    model.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
    for (const char* file : {"color.png", "normal.png"}) model.add("images", {{"uri", file}});
}

/// One mesh in one node with one material.
inline TestModel modelOf(const Mesh& mesh, const json& material) {
    TestModel model;
    addTextures(model);
    addMesh(model, mesh, {{"material", 0}});
    model.add("materials", material);
    model.add("nodes", {{"mesh", 0}});
    return model;
}

inline json textured(const json& more = json::object(), bool bent = true) {
    json material{{"doubleSided", true},
                  {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.5}}}};
    json texture = more;
    texture["index"] = 0;
    material["pbrMetallicRoughness"]["baseColorTexture"] = texture;
    texture["index"] = 1;
    if (bent) material["normalTexture"] = texture;
    return material;
}

class GltfPictureTest : public test::GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        std::string name = std::filesystem::temp_directory_path() / "vitrine-gltf-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        for (const bool normals : {false, true}) {
            const auto png = encodePng(randomPicture(normals));
            write(normals ? "normal.png" : "color.png", std::string(png.begin(), png.end()));
        }
    }
    void TearDown() override {
        if (!folder.empty()) std::filesystem::remove_all(folder);
    }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    [[nodiscard]] ImageRgba8 draw(const std::string& nodes, View view = View::kColor,
                                  float time = 0) const {
        write("scene.toml", kStage + nodes);
        Diagnostics diagnostics;
        const LoadedScene loaded = loadAll(folder / "scene.toml", {}, diagnostics);
        EXPECT_EQ(diagnostics.text(), "");
        PictureRequest request;
        request.width = 200;
        request.height = 150;
        request.samples = 1;
        request.view = view;
        request.time = time;
        return test::drawPicture(loaded, Backend::kFragment, request);
    }
    [[nodiscard]] ImageRgba8 draw(const TestModel& model, View view = View::kColor) const {
        write("model.glb", model.glb());
        return draw("[[node]]\ninclude = \"model.glb\"\n", view);
    }
    static void expectSame(const ImageRgba8& a, const ImageRgba8& b) {
        const Comparison c = compareImages(a, b);
        EXPECT_LT(c.fractionOver, 0.001) << c.pixelsOver << " pixels, PSNR " << c.psnr;
    }
    static void expectDifferent(const ImageRgba8& a, const ImageRgba8& b) {
        EXPECT_GT(compareImages(a, b).fractionOver, 0.05);
    }
    std::filesystem::path folder;
};

/// The mesh in the other format.
inline std::string objOf(const Mesh& mesh) {
    std::string text;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 &p = mesh.positions[i], &n = mesh.normals[i];
        text += fmt::format("v {} {} {}\nvn {} {} {}\nvt {} {}\n", p.x, p.y, p.z, n.x, n.y, n.z,
                            mesh.uvs[i].x, mesh.uvs[i].y);
    }
    for (const glm::uvec3& t : mesh.triangles)
        text += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", t.x + 1, t.y + 1, t.z + 1);
    return text;
}

inline json quaternion(float degrees, const glm::vec3& axis) {
    const glm::quat q = glm::angleAxis(glm::radians(degrees), axis);
    return {q.x, q.y, q.z, q.w};
}

inline Mesh mirrored(Mesh mesh) {
    for (glm::vec3& p : mesh.positions) p.x = -p.x;
    for (glm::vec3& n : mesh.normals) n.x = -n.x;
    for (glm::vec4& t : mesh.tangents) t = glm::vec4(-t.x, t.y, t.z, -t.w);
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

/// Tangents of a sphere as they are by its formula.
inline Mesh withParallels(Mesh sphere) {
    for (const glm::vec3& n : sphere.normals) {
        const float parallel = std::hypot(n.x, n.z);
        sphere.tangents.emplace_back(parallel > 0 ? n.z / parallel : 1, 0,
                                     parallel > 0 ? -n.x / parallel : 0, 1);
    }
    return sphere;
}

}  // namespace vitrine
