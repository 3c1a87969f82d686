// SPDX-License-Identifier: MIT
// Where the parts of glTF models are, and how they move.
#include "gpu_gltf_support.hpp"

namespace vitrine {
namespace {

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
