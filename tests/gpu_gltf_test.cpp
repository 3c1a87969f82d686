// SPDX-License-Identifier: MIT
// Pictures of glTF models against pictures of the same things made in another way. Pictures are
// equal if at most 0.1 % of their pixels are off by more than 5 of 255: transforms are multiplied
// in another order, which moves edges by rounding errors.
#include "gltf/test_model.hpp"
#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "import/import_models.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

using nlohmann::json;

constexpr const char* kStage = R"([render]
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
ImageRgba8 randomPicture(bool normals, int size = 16) {
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

size_t addMesh(TestModel& model, const Mesh& mesh, const json& more = json::object()) {
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
void addTextures(TestModel& model) {
    model.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
    for (const char* file : {"color.png", "normal.png"}) model.add("images", {{"uri", file}});
}

/// One mesh in one node with one material.
TestModel modelOf(const Mesh& mesh, const json& material) {
    TestModel model;
    addTextures(model);
    addMesh(model, mesh, {{"material", 0}});
    model.add("materials", material);
    model.add("nodes", {{"mesh", 0}});
    return model;
}

json textured(const json& more = json::object(), bool bent = true) {
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
std::string objOf(const Mesh& mesh) {
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

json quaternion(float degrees, const glm::vec3& axis) {
    const glm::quat q = glm::angleAxis(glm::radians(degrees), axis);
    return {q.x, q.y, q.z, q.w};
}

TEST_F(GltfPictureTest, ABoxUnderNodesIsTheBoxOfAnObjFile) {
    const Mesh box = makeBox({0.5f, 0.3f, 0.4f});
    write("box.obj", objOf(box));
    const std::string nodes = R"([material.m]
base_color = [1, 1, 1]
base_color_texture = "color.png"
normal_texture = "normal.png"
[shape.box]
mesh = "box.obj"
[[node]]
name = "outer"
at = [0.2, 0.3, 0]
rotate = [0, 30, 0]
scale = [1.5, 1.5, 2.5]
[[node]]
parent = "outer"
shape = "box"
material = "m"
at = [0.1, 0, -0.2]
rotate = [40, 0, 0]
scale = [1, 2, 0.5]
)";
    TestModel model = modelOf(box, textured());
    glm::mat4 m = glm::translate(glm::mat4(1), {0.1f, 0, -0.2f});
    m = glm::scale(glm::rotate(m, glm::radians(40.0f), {1, 0, 0}), {1, 2, 0.5f});
    std::vector<float> matrix(&m[0][0], &m[0][0] + 16);
    model.json["nodes"] = {{{"rotation", quaternion(30, {0, 1, 0})}, {"children", {1}}},
                           {{"scale", {1.5, 1.5, 2.5}}, {"children", {2}}},
                           {{"mesh", 0}, {"matrix", matrix}}};
    write("model.glb", model.glb());
    for (const View view : {View::kColor, View::kNormal, View::kDepth}) {
        const ImageRgba8 byObj = draw(nodes, view);
        expectSame(draw("[[node]]\ninclude = \"model.glb\"\nat = [0.2, 0.3, 0]\n", view), byObj);
        expectSame(draw("[shape.s]\nmesh = \"model.glb\"\n[[node]]\nshape = \"s\"\n"
                        "at = [0.2, 0.3, 0]\n",
                        view),
                   byObj);
        expectDifferent(draw("[[node]]\ninclude = \"model.glb\"\nat = [0.4, 0.3, 0]\n", view),
                        byObj);
    }
}

Mesh mirrored(Mesh mesh) {
    for (glm::vec3& p : mesh.positions) p.x = -p.x;
    for (glm::vec3& n : mesh.normals) n.x = -n.x;
    for (glm::vec4& t : mesh.tangents) t = glm::vec4(-t.x, t.y, t.z, -t.w);
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

/// Tangents of a sphere as they are by its formula.
Mesh withParallels(Mesh sphere) {
    for (const glm::vec3& n : sphere.normals) {
        const float parallel = std::hypot(n.x, n.z);
        sphere.tangents.emplace_back(parallel > 0 ? n.z / parallel : 1, 0,
                                     parallel > 0 ? -n.x / parallel : 0, 1);
    }
    return sphere;
}

TEST_F(GltfPictureTest, AMirroredNodeIsAMirroredMesh) {
    Mesh sphere = makeSphere(1, 12);
    for (glm::vec3& p : sphere.positions)
        if (p.x > 0.2f) p.x += 0.5f;  // with one cheek
    for (const Mesh& mesh : {sphere, withParallels(sphere)}) {
        TestModel model = modelOf(mesh, textured());
        model.json["nodes"][0]["scale"] = {-1, 1, 1};
        for (const View view : {View::kColor, View::kNormal}) {
            const ImageRgba8 expected = draw(modelOf(mirrored(mesh), textured()), view);
            expectSame(draw(model, view), expected);
            expectDifferent(draw(modelOf(mesh, textured()), view), expected);
            write("model.glb", model.glb());
            expectSame(draw("[shape.s]\nmesh = \"model.glb\"\n[[node]]\nshape = \"s\"\n", view),
                       expected);
        }
    }
}

TEST_F(GltfPictureTest, TheIncludingNodeScalesAndMirrors) {
    // Seen from the front only, so that a reflection that forgets to turn triangles shows nothing.
    Mesh ball = withParallels(makeSphere(0.5f, 24)), large = mirrored(ball);
    for (glm::vec3& p : large.positions) p *= 1.5f;
    json material = textured();
    material["doubleSided"] = false;
    const ImageRgba8 expected = draw(modelOf(large, material));
    write("ball.glb", modelOf(ball, material).glb());
    expectSame(draw("[[node]]\ninclude = \"ball.glb\"\nscale = [-1.5, 1.5, 1.5]\n"), expected);
    expectSame(draw("[[node]]\nname = \"up\"\nscale = -1.5\n[[node]]\nparent = \"up\"\n"
                    "include = \"ball.glb\"\nrotate = [180, 0, 0]\n"),
               expected);
    expectDifferent(draw("[[node]]\ninclude = \"ball.glb\"\n"), expected);
}

TEST_F(GltfPictureTest, TangentsByFormulaByFileAndByTriangleAgree) {
    const Mesh sphere = makeSphere(1, 48);
    const ImageRgba8 given = draw(modelOf(withParallels(sphere), textured()), View::kNormal);
    const ImageRgba8 generated = draw(modelOf(sphere, textured()), View::kNormal);
    write("ball.obj", objOf(sphere));
    const ImageRgba8 byTriangle = draw(R"([material.m]
normal_texture = "normal.png"
[shape.s]
mesh = "ball.obj"
[[node]]
shape = "s"
material = "m"
)",
                                       View::kNormal);
    expectSame(given, generated);
    // Triangles have one direction each, which is off by half of their width: 2 degrees.
    EXPECT_LT(compareImages(given, byTriangle, 12).fractionOver, 0.01);
    expectDifferent(given, draw(modelOf(sphere, textured({}, false)), View::kNormal));
}

TEST_F(GltfPictureTest, SeenFromBehindABumpIsADent) {
    // Its back is the front of a plane that faces away, with all slopes reversed.
    Mesh plane = makePlane(1, 1);
    plane.tangents.assign(4, {1, 0, 0, 1});
    TestModel model = modelOf(plane, textured());
    model.json["nodes"][0]["rotation"] = quaternion(180, {1, 0, 0});
    Mesh turned = plane;
    for (glm::vec3& n : turned.normals) n = -n;
    turned.tangents.assign(4, {1, 0, 0, -1});
    for (glm::uvec3& t : turned.triangles) std::swap(t.y, t.z);
    json reversed = textured();
    reversed["normalTexture"]["scale"] = -1;
    TestModel other = modelOf(turned, reversed);
    other.json["nodes"] = model.json["nodes"];
    expectSame(draw(model, View::kNormal), draw(other, View::kNormal));
    expectDifferent(draw(model, View::kNormal), draw(modelOf(turned, textured()), View::kNormal));
}

TEST_F(GltfPictureTest, TextureTransformsAreTransformedCoordinates) {
    const Mesh plane = makePlane(1, 1);
    const json transform = {{"offset", {0.3, -0.2}}, {"rotation", 0.6}, {"scale", {2, 1.5}}};
    TestModel model =
        modelOf(plane, textured({{"extensions", {{"KHR_texture_transform", transform}}}}, false));
    model.json["extensionsUsed"] = {"KHR_texture_transform"};
    Mesh moved = plane;
    for (glm::vec2& uv : moved.uvs) {
        const float u = 2 * uv.x, v = 1.5f * (1 - uv.y);  // as in the file, downwards
        uv = {0.3f + std::cos(0.6f) * u + std::sin(0.6f) * v,
              1 - (-0.2f - std::sin(0.6f) * u + std::cos(0.6f) * v)};
    }
    const ImageRgba8 picture = draw(model, View::kAlbedo);
    expectSame(picture, draw(modelOf(moved, textured({}, false)), View::kAlbedo));
    expectDifferent(picture, draw(modelOf(plane, textured({}, false)), View::kAlbedo));
}

TEST_F(GltfPictureTest, TheSecondCoordinatesAreAsGoodAsTheFirst) {
    const Mesh plane = makePlane(1, 1);
    Mesh second = plane;
    second.uvs2 = plane.uvs;
    for (glm::vec2& uv : second.uvs) uv = {uv.y * 3, 0.2f};
    for (const View view : {View::kAlbedo, View::kNormal}) {
        const ImageRgba8 expected = draw(modelOf(plane, textured()), view);
        expectSame(draw(modelOf(second, textured({{"texCoord", 1}})), view), expected);
        expectDifferent(draw(modelOf(second, textured()), view), expected);
    }
}

TEST_F(GltfPictureTest, ColoursOfVerticesMultiplyTheMaterials) {
    Mesh plane = makePlane(1, 1);
    json material{{"pbrMetallicRoughness", {{"metallicFactor", 0}}}};
    json& pbr = material["pbrMetallicRoughness"];
    pbr["baseColorFactor"] = {0.1, 0.4, 0.02, 1};
    const ImageRgba8 expected = draw(modelOf(plane, material));
    plane.colors.assign(4, {0.2f, 0.5f, 0.04f, 1});
    pbr["baseColorFactor"] = {0.5, 0.8, 0.5, 1};
    expectSame(draw(modelOf(plane, material)), expected);
    expectDifferent(draw(modelOf(makePlane(1, 1), material)), expected);
}

TEST_F(GltfPictureTest, WhatMovesIsWhereItsKeysPutIt) {
    const Mesh box = makeBox({0.4f, 0.3f, 0.2f});
    TestModel model = modelOf(box, textured({}, false));
    const size_t times = model.addAccessor<float>({0, 1, 2}, "SCALAR", 3);
    const glm::quat half = glm::angleAxis(glm::radians(50.0f), glm::vec3(0, 1, 0));
    const size_t turns = model.addAccessor<float>(
        {0, 0, 0, 1, half.x, half.y, half.z, half.w, 0, 0, 0, 1}, "VEC4", 3);
    const size_t places = model.addAccessor<float>({-1, 0, 0, 1, 0.5f, 0, -1, 0, 0}, "VEC3", 3);
    const size_t sizes = model.addAccessor<float>({1, 1, 1, 1, 2, 1, 0, 0, 0}, "VEC3", 3);
    json& animation = model.json["animations"][0];
    int channel = 0;
    for (const auto& [path, values] :
         {std::pair{"rotation", turns}, {"translation", places}, {"scale", sizes}}) {
        animation["samplers"].push_back(
            {{"input", times},
             {"output", values},
             {"interpolation", std::string(path) == "scale" ? "STEP" : "LINEAR"}});
        animation["channels"].push_back(
            {{"sampler", channel++}, {"target", {{"node", 0}, {"path", path}}}});
    }
    write("moving.glb", model.glb());
    const auto moving = [&](float time) {
        return draw("[[node]]\ninclude = \"moving.glb\"\n", View::kColor, time);
    };
    const auto still = [&](const glm::vec3& at, float degrees, float height) {
        TestModel other = modelOf(box, textured({}, false));
        json& node = other.json["nodes"][0];
        node["translation"] = {at.x, at.y, at.z};
        node["rotation"] = quaternion(degrees, {0, 1, 0});
        node["scale"] = {1, height, 1};
        return draw(other);
    };
    expectSame(moving(0), still({-1, 0, 0}, 0, 1));
    expectSame(moving(0.5f), still({0, 0.25f, 0}, 25, 1));
    expectSame(moving(1.5f), still({0, 0.25f, 0}, 25, 2));
    expectSame(moving(2.5f), still({0, 0.25f, 0}, 25, 1));  // two seconds are one round
    expectDifferent(moving(0), moving(0.5f));
}

TEST_F(GltfPictureTest, MeshesWithAndWithoutListsStandTogether) {
    // Lists of one mesh must not be taken for another's: a plain mesh, one with all, a plain one.
    const Mesh ball = makeSphere(0.25f, 16);
    Mesh rich = withParallels(ball);
    rich.uvs2 = ball.uvs;
    for (const glm::vec3& n : ball.normals) rich.colors.emplace_back(0.5f * n + 0.5f, 1);
    const auto nodesWith = [&](const std::vector<size_t>& shown) {
        TestModel model;
        addTextures(model);
        for (const Mesh& mesh : {ball, rich, ball, rich})
            addMesh(model, mesh, {{"material", mesh.colors.empty() ? 0 : 1}});
        model.add("materials", textured({}, false));
        model.add("materials", textured({{"texCoord", 1}}));
        for (const size_t i : shown)
            model.add("nodes",
                      {{"mesh", i}, {"translation", {static_cast<double>(i) - 1.5, 0, 0}}});
        return draw(model, View::kAlbedo);
    };
    const ImageRgba8 together = nodesWith({0, 1, 2, 3});
    for (size_t i = 0; i < 4; ++i) {
        const ImageRgba8 alone = nodesWith({i});
        size_t seen = 0, wrong = 0;
        for (int y = 0; y < alone.height; ++y)
            for (int x = 0; x < alone.width; ++x) {
                const auto a = alone.at(x, y), b = together.at(x, y);
                if (a[0] == 0 && a[1] == 0 && a[2] == 0) continue;
                ++seen;
                for (size_t c = 0; c < 3; ++c) wrong += std::abs(a[c] - b[c]) > 5 ? 1 : 0;
            }
        EXPECT_GT(seen, 150u) << i;
        EXPECT_LT(wrong, seen / 50) << i;
    }
}

TEST_F(GltfPictureTest, TheNearestTexelIsNotBlended) {
    const Mesh plane = makePlane(3, 3);  // magnified, or there are smaller pictures to blend
    TestModel model = modelOf(plane, textured({}, false));
    model.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9728}}};
    model.json["textures"][0]["sampler"] = 0;
    std::set<std::array<int, 3>> texels;
    const ImageRgba8 source = randomPicture(false);
    for (size_t i = 0; i < source.pixels.size(); i += 4)
        texels.insert({source.pixels[i], source.pixels[i + 1], source.pixels[i + 2]});
    const auto shareOfTexels = [&](const ImageRgba8& image) {
        double seen = 0, pure = 0;
        for (size_t i = 0; i < image.pixels.size(); i += 4) {
            const std::array<int, 3> c{image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
            if (c == std::array<int, 3>{}) continue;
            ++seen;
            for (const auto& t : texels)
                if (std::abs(t[0] - c[0]) + std::abs(t[1] - c[1]) + std::abs(t[2] - c[2]) <= 6) {
                    ++pure;
                    break;
                }
        }
        EXPECT_GT(seen, 3000);
        return pure / seen;
    };
    EXPECT_GT(shareOfTexels(draw(model, View::kAlbedo)), 0.98);
    model.json.erase("samplers");
    model.json["textures"][0].erase("sampler");
    EXPECT_LT(shareOfTexels(draw(model, View::kAlbedo)), 0.3);
}

/// Models that people made, if the environment variable VITRINE_TEST_DATA names a folder with them.
TEST_F(GltfPictureTest, RealModelsAreTheSameAsNodesAndAsOneShape) {
    const char* data = std::getenv("VITRINE_TEST_DATA");
    if (data == nullptr) GTEST_SKIP() << "VITRINE_TEST_DATA is not set";
    for (const char* name : {"FlightHelmet/FlightHelmet.gltf", "ToyCar/ToyCar.glb"}) {
        const std::filesystem::path file = std::filesystem::path(data) / name;
        if (!std::filesystem::exists(file)) continue;
        Diagnostics diagnostics;
        LoadedScene bare = loadAll(file, {"render.ao=0", "render.bounces=0"}, diagnostics);
        EXPECT_FALSE(diagnostics.hasErrors()) << diagnostics.text();
        PictureRequest request;
        request.width = 200;
        request.height = 150;
        request.samples = 1;
        // Veils and glass let rays pass by chance, and the chance depends on the numbers of
        // instances and triangles, which differ.
        const auto makeSolid = [&bare] {
            for (Material& m : bare.scene.materials) {
                m.alphaMode = AlphaMode::kOpaque;
                m.transmission = 0;
            }
        };
        makeSolid();
        bare.packed = packScene(bare.scene, bare.assets, diagnostics);
        const ImageRgba8 asNodes = test::drawPicture(bare, Backend::kFragment, request);
        // The same scene with the one shape in place of the model's nodes.
        std::erase_if(bare.scene.nodes,
                      [](const Node& n) { return n.name.starts_with("object/"); });
        Shape shape;
        shape.name = "whole";
        shape.mesh.name = file.filename().string();
        bare.scene.shapes.push_back(shape);
        for (Node& node : bare.scene.nodes)
            if (node.name == "object") {
                node.include = {};
                node.shape.name = "whole";
            }
        ModelLibrary library;
        importModels(bare.scene, library, diagnostics);
        makeSolid();
        bare.assets = loadAssets(bare.scene, diagnostics);
        bare.packed = packScene(bare.scene, bare.assets, diagnostics);
        EXPECT_FALSE(diagnostics.hasErrors()) << diagnostics.text();
        expectSame(test::drawPicture(bare, Backend::kFragment, request), asNodes);
    }
}

}  // namespace
}  // namespace vitrine
