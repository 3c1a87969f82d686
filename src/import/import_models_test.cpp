// SPDX-License-Identifier: MIT
#include "import/import_models.hpp"

#include "gltf/test_model.hpp"
#include "mesh/mesh.hpp"
#include "scene/parse.hpp"

namespace vitrine {
namespace {

using nlohmann::json;

/// Two squares with materials, in a node with a camera and lights below it.
TestModel house() {
    TestModel model = square();
    model.json["materials"] =
        json::parse(R"([{"name": "Brick"}, {"name": "Brick"}, {"name": "Unused"}])");
    model.json["meshes"] = json::parse(R"([{"name": "wall", "primitives": [
        {"attributes": {"POSITION": 0}, "indices": 1, "material": 0},
        {"attributes": {"POSITION": 0}, "indices": 1, "material": 1},
        {"attributes": {"POSITION": 0}, "indices": 1}]}])");
    model.json["cameras"] = json::parse(R"([{"name": "eye", "type": "perspective",
        "perspective": {"yfov": 0.5, "znear": 0.1}}])");
    model.json["extensionsUsed"] = {"KHR_lights_punctual"};
    model.json["extensions"]["KHR_lights_punctual"]["lights"] = json::parse(R"([
        {"name": "lamp", "type": "spot", "intensity": 7, "range": 9, "color": [1, 0.5, 0.25],
         "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}},
        {"name": "sun", "type": "directional", "intensity": 2}, {"name": "bulb", "type": "point"}])");
    // The quarter turn about y takes -z, where cameras and lights look, to -x.
    model.json["nodes"] = json::parse(R"([
        {"name": "hall", "translation": [0, 0, 5], "children": [1, 2, 3, 4, 5]},
        {"name": "left", "mesh": 0},
        {"name": "left", "mesh": 0, "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 1,0,0,1]},
        {"camera": 0, "translation": [0, 1, 0], "rotation": [0, 0.70710678, 0, 0.70710678],
         "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"extensions": {"KHR_lights_punctual": {"light": 1}}},
        {"extensions": {"KHR_lights_punctual": {"light": 2}}}])");
    return model;
}

class ImportModels : public GltfTest {
  protected:
    void SetUp() override {
        GltfTest::SetUp();
        write("house.glb", house().glb());
    }
    /// What is wrong is in `messages`, without the folder.
    Scene load(const std::string& text, const std::vector<std::string>& overrides = {}) {
        Diagnostics diagnostics;
        Scene scene = parseScene(text, (folder / "t").string(), overrides, diagnostics);
        ModelLibrary library;
        importModels(scene, library, diagnostics);
        messages = diagnostics.text();
        const std::string prefix = folder.string() + "/";
        for (size_t at; (at = messages.find(prefix)) != std::string::npos;)
            messages.erase(at, prefix.size());
        return scene;
    }
    template <class T>
    static std::vector<std::string> names(const std::vector<T>& objects) {
        std::vector<std::string> result;
        for (const T& object : objects) result.push_back(object.name);
        return result;
    }
    template <class T>
    static const T& find(const std::vector<T>& objects, const std::string& name) {
        for (const T& object : objects)
            if (object.name == name) return object;
        throw std::runtime_error("no " + name + " in " + testing::PrintToString(names(objects)));
    }
    static void expectNear(const glm::vec3& a, const glm::vec3& b) {
        EXPECT_LT(glm::distance(a, b), 1e-5f)
            << testing::PrintToString(a.x) << ' ' << a.y << ' ' << a.z;
    }
};
using Names = std::vector<std::string>;

TEST_F(ImportModels, EverythingHasItsPlaceAndName) {
    const Scene scene = load("[[node]]\nname = \"h\"\ninclude = \"house.glb\"\nat = [100, 0, 0]\n");
    EXPECT_EQ(messages, "");
    EXPECT_EQ(names(scene.nodes),
              (Names{"h", "h/hall", "h/left", "h/left#2", "h/node 3", "h/node 4", "h/node 5"}));
    EXPECT_EQ(names(scene.shapes), (Names{"house/wall"}));
    EXPECT_EQ(names(scene.materials), (Names{"house/Brick", "house/Brick#2", "house/default"}));
    const auto& parts = scene.shapes[0].partMaterials;
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[1], std::make_pair(std::string("Brick#2"), std::string("house/Brick#2")));
    EXPECT_EQ(scene.shapes[0].imported->partNames, (Names{"Brick", "Brick#2", "default"}));

    const std::vector<glm::mat4> world = worldFromNodes(scene);
    expectNear(glm::vec3(world[2][3]), {100, 0, 5});
    expectNear(glm::vec3(world[3] * glm::vec4(1, 1, 0, 1)), {103, 2, 5});

    ASSERT_EQ(names(scene.cameras), (Names{"h/eye"})) << "in place of the default";
    const Camera& camera = scene.cameras[0];
    expectNear(camera.eye, {100, 1, 5});
    expectNear(glm::normalize(camera.target - camera.eye), {-1, 0, 0});
    expectNear(camera.up, {0, 1, 0});
    EXPECT_NEAR(camera.fov, glm::degrees(0.5f), 1e-4f);

    ASSERT_EQ(names(scene.lights), (Names{"h/lamp", "h/sun", "h/bulb"}));
    const Light& lamp = scene.lights[0];
    EXPECT_EQ(lamp.type, LightType::kSpot);
    expectNear(lamp.at, {100, 1, 5});
    expectNear(lamp.direction, {-1, 0, 0});
    expectNear(lamp.color.rgb, {1, 0.5f, 0.25f});
    EXPECT_EQ(lamp.intensity, 7);
    EXPECT_EQ(lamp.range, 9);
    EXPECT_NEAR(lamp.innerAngle, glm::degrees(0.1f), 1e-4f);
    EXPECT_NEAR(lamp.outerAngle, glm::degrees(0.2f), 1e-4f);
    EXPECT_EQ(scene.lights[1].type, LightType::kSun);
    expectNear(scene.lights[1].direction, {0, 0, -1});
    EXPECT_EQ(scene.lights[2].type, LightType::kPoint);
}

TEST_F(ImportModels, ASceneMayHaveLostItsCameras) {
    Diagnostics diagnostics;
    Scene scene = parseScene("[[camera]]\nfov = \"wide\"\n", "t", {}, diagnostics);
    ASSERT_TRUE(diagnostics.hasErrors());
    scene.cameras = std::vector<Camera>();
    ModelLibrary library;
    importModels(scene, library, diagnostics);
    EXPECT_TRUE(scene.cameras.empty());
}

TEST_F(ImportModels, AModelIsReadOnceAndShared) {
    const Scene scene = load(
        "[[node]]\ninclude = \"house.glb\"\n[[node]]\ninclude = \"./house.glb\"\n"
        "[shape.a]\nmesh = \"house.glb\"\n[shape.b]\nmesh = \"house.glb\"\n"
        "[[node]]\nshape = \"a\"\n");
    EXPECT_EQ(messages, "");
    EXPECT_EQ(names(scene.materials), (Names{"house/Brick", "house/Brick#2", "house/default"}));
    ASSERT_EQ(names(scene.shapes), (Names{"a", "b", "house/wall"}));
    EXPECT_EQ(scene.shapes[0].imported, scene.shapes[1].imported);
    EXPECT_EQ(scene.shapes[0].imported->triangles.size(), 12u) << "the wall stands there twice";
    EXPECT_EQ(find(scene.nodes, "house/left").shape.name, "house/wall");
    EXPECT_EQ(find(scene.nodes, "house#2/left").shape.name, "house/wall");
}

TEST_F(ImportModels, NamesGiveWay) {
    const Scene scene = load(
        "[material.\"house/Brick\"]\n[shape.\"house/wall\"]\nsphere = {}\n"
        "[[node]]\nname = \"h\"\ninclude = \"house.glb\"\n[[node]]\nname = \"h/left\"\n"
        "[[camera]]\nname = \"h/eye\"\n");
    EXPECT_EQ(messages, "");
    EXPECT_EQ(names(scene.materials),
              (Names{"house/Brick", "house/Brick#2", "house/Brick#2#2", "house/default"}));
    EXPECT_EQ(names(scene.shapes), (Names{"house/wall", "house/wall#2"}));
    EXPECT_EQ(names(scene.cameras), (Names{"h/eye", "h/eye#2"}));
    EXPECT_EQ(find(scene.nodes, "h/left").shape.name, "");
    EXPECT_EQ(find(scene.nodes, "h/left#2").shape.name, "house/wall#2");
}

TEST_F(ImportModels, MaterialsCanBeReplaced) {
    const Scene scene = load(
        "[material.gold]\n[[node]]\nname = \"a\"\ninclude = \"house.glb\"\nmaterial = \"gold\"\n"
        "[[node]]\nname = \"b\"\ninclude = \"house.glb\"\nparts = { \"Brick#2\" = \"gold\" }\n"
        "[[node]]\nname = \"c\"\ninclude = \"house.glb\"\nvisible = false\n");
    EXPECT_EQ(messages, "");
    EXPECT_EQ(find(scene.nodes, "a/left").material.name, "gold");
    EXPECT_EQ(find(scene.nodes, "a/hall").material.name, "");
    EXPECT_EQ(find(scene.nodes, "b/left").material.name, "");
    ASSERT_EQ(find(scene.nodes, "b/left").parts.size(), 1u);
    EXPECT_EQ(find(scene.nodes, "b/left").parts[0].second.name, "gold");
    EXPECT_FALSE(find(scene.nodes, "c/left").visible);
    EXPECT_EQ(scene.lights.size(), 6u) << "what is not visible sheds no light";
    (void)load("[material.gold]\n[[node]]\ninclude = \"house.glb\"\nparts = { Brik = \"gold\" }\n");
    EXPECT_EQ(messages,
              "t:4:11: error: 'house.glb' has no material 'Brik' (did you mean 'Brick'?)");
}

TEST_F(ImportModels, OverridesReachIntoModels) {
    constexpr const char* kScene = "[[node]]\nname = \"h\"\ninclude = \"house.glb\"\n";
    const Scene scene =
        load(kScene, {"material.house/Brick#2.roughness=0.25", "node.h/hall.at=[1,2,3]",
                      "light.h/lamp.intensity=42", "light.h/sun.direction=[0,-1,0]",
                      "node.h/left.material=house/default"});
    EXPECT_EQ(messages, "");
    EXPECT_EQ(scene.materials[1].roughness, 0.25f);
    EXPECT_EQ(scene.materials[0].roughness, 1);
    expectNear(scene.cameras[0].eye, {1, 3, 3});
    EXPECT_EQ(scene.lights[0].intensity, 42);
    expectNear(scene.lights[0].at, {1, 3, 3});
    expectNear(scene.lights[1].direction, {0, -1, 0});
    EXPECT_EQ(find(scene.nodes, "h/left").material.name, "house/default");

    const auto problem = [&](const std::string& assignment) {
        (void)load(kScene, {assignment});
        return messages;
    };
    EXPECT_EQ(problem("material.house/Brik.roughness=1"),
              "--set material.house/Brik.roughness=1: error: the scene has no material "
              "'house/Brik' (did you mean 'house/Brick'?)");
    EXPECT_EQ(problem("material.house/Brick.rougness=1"),
              "--set material.house/Brick.rougness=1: error: unknown key 'rougness' in "
              "[material.house/Brick] (did you mean 'roughness'?)");
    EXPECT_NE(problem("material.house/Brick.roughness=2").find("roughness is 2"),
              std::string::npos);
    EXPECT_NE(problem("camera.h/eye.fov=2").find("only materials, nodes and lights"),
              std::string::npos);
    EXPECT_NE(problem("node.h/left.scale=0").find("scale must not be zero"), std::string::npos);
    EXPECT_NE(problem("node.h/left.material=iron").find("no material is named 'iron'"),
              std::string::npos);
    EXPECT_NE(problem("node.h/hall.parent=h/left").find("its own ancestor"), std::string::npos);
    EXPECT_NE(problem("light.h/sun.direction=[0,0,0]").find("no length"), std::string::npos);
}

TEST_F(ImportModels, TheSceneMayNameWhatModelsBring) {
    const Scene scene = load(
        "[[node]]\nname = \"h\"\ninclude = \"house.glb\"\n[shape.ball]\nsphere = {}\n"
        "[[node]]\nname = \"guest\"\nparent = \"h/hall\"\nshape = \"ball\"\n"
        "material = \"house/Brick\"\n");
    EXPECT_EQ(messages, "");
    EXPECT_EQ(worldFromNodes(scene)[1][3], glm::vec4(0, 0, 5, 1));
    (void)load(
        "[[node]]\nname = \"h\"\ninclude = \"house.glb\"\nparent = \"h/hall\"\n"
        "[[node]]\nparent = \"h/hal\"\n");
    EXPECT_NE(messages.find("t:6:10: error: no node is named 'h/hal' (did you mean 'h/hall'?)"),
              std::string::npos)
        << messages;
    EXPECT_NE(messages.find("is its own ancestor"), std::string::npos) << messages;
}

TEST_F(ImportModels, ErrorsHaveTheirPlace) {
    std::filesystem::create_directories(folder / "inside");
    write("inside/ok.glb", house().glb());
    const auto problem = [&](const std::string& include) {
        (void)load("[[node]]\ninclude = \"" + include + "\"\n");
        return messages;
    };
    EXPECT_EQ(problem("inside/ok.glb"), "");
    EXPECT_EQ(problem("../x.glb"),
              "t:2:11: error: '../x.glb': the path leads out of the scene's folder");
    EXPECT_NE(problem("/etc/x.glb").find("t:2:11: error: '/etc/x.glb': the path is absolute"),
              std::string::npos);
    EXPECT_EQ(problem("none.glb"), "t:2:11: error: 'none.glb': there is no such file");
    EXPECT_EQ(problem("t.toml"), "t:2:11: error: what is included is a .gltf or .glb file");
    EXPECT_NE(problem("inside").find("t:2:11: error"), std::string::npos);

    TestModel broken = house();
    broken.json["nodes"][1]["mesh"] = 9;
    write("broken.gltf", broken.gltf(1));
    EXPECT_NE(problem("broken.gltf").find("broken.gltf:"), std::string::npos) << messages;
    EXPECT_NE(messages.find("/nodes/1/mesh"), std::string::npos) << messages;
    (void)load("[shape.s]\nmesh = \"broken.gltf\"\n[[node]]\nshape = \"s\"\n");
    EXPECT_NE(messages.find("/nodes/1/mesh"), std::string::npos) << messages;
    (void)load("[shape.s]\nmesh = \"../x.gltf\"\n");
    EXPECT_EQ(messages, "t:2:8: error: '../x.gltf': the path leads out of the scene's folder");
    (void)load("[shape.s]\nsphere = {}\n[[node]]\nshape = \"s\"\ninclude = \"house.glb\"\n");
    EXPECT_EQ(messages, "t:5:11: error: give shape or include, not both");
    (void)load("[[node]]\ninclude = \"house.glb\"\nset = { x = 1 }\n");
    EXPECT_EQ(messages, "t:3:7: error: set has no effect: the node has no shape");
}

TEST_F(ImportModels, ALinkOutOfTheFolderIsNotFollowed) {
    std::filesystem::create_directories(folder / "scenes");
    std::filesystem::create_symlink("../house.glb", folder / "scenes/link.glb");
    Diagnostics diagnostics;
    Scene scene = parseScene("[[node]]\ninclude = \"link.glb\"\n", (folder / "scenes/t").string(),
                             {}, diagnostics);
    ModelLibrary library;
    importModels(scene, library, diagnostics);
    EXPECT_NE(diagnostics.text().find("leads out of the scene's folder"), std::string::npos);
    EXPECT_EQ(scene.nodes.size(), 1u);
}

TEST_F(ImportModels, WhatIsTooSmallToDrawIsLeftOutWithAWarning) {
    const Scene scene = load(
        "[[node]]\nname = \"h\"\ninclude = \"house.glb\"\nscale = 1e-9\n"
        "[[node]]\nname = \"g\"\nparent = \"h\"\nscale = 1e-9\n"
        "[[node]]\nname = \"k\"\nparent = \"g\"\nscale = 1e-9\ninclude = \"house.glb\"\n");
    EXPECT_EQ(messages,
              "t:13:11: warning: 2 nodes of 'house.glb' left out: with their parents too flat, "
              "small or large");
    EXPECT_EQ(find(scene.nodes, "k/left").shape.name, "");
    EXPECT_EQ(find(scene.nodes, "h/left").shape.name, "house/wall");
}

TEST_F(ImportModels, TooManyNodesAreRefused) {
    TestModel crowd = square();
    crowd.json["nodes"] = json::array();
    crowd.json["scenes"][0]["nodes"] = json::array();
    for (int i = 0; i < 50000; ++i) {
        crowd.json["nodes"].push_back(json::object());
        crowd.json["scenes"][0]["nodes"].push_back(i);
    }
    write("crowd.glb", crowd.glb());
    std::string text;
    for (int i = 0; i < 10; ++i) text += "[[node]]\ninclude = \"crowd.glb\"\n";
    const Scene scene = load(text);
    EXPECT_NE(messages.find("t:12:11: error: the models of the scene have more than 262144"),
              std::string::npos)
        << messages.substr(0, 300);
    EXPECT_LT(scene.nodes.size(), 270000u);
}

TEST_F(ImportModels, ABrokenPictureIsACheckerboardAndOneWarning) {
    TestModel model = house();
    model.json["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgo="}}};
    model.json["textures"] = {{{"source", 0}}};
    model.json["materials"][0]["normalTexture"] = {{"index", 0}};
    model.json["materials"][1]["normalTexture"] = {{"index", 0}};
    write("house.glb", model.glb());
    const Scene scene = load("[[node]]\ninclude = \"house.glb\"\n");
    EXPECT_NE(messages.find("warning"), std::string::npos) << messages;
    EXPECT_EQ(messages.find("error"), std::string::npos) << messages;
    ASSERT_NE(scene.materials[0].normalTexture.image, nullptr);
    EXPECT_EQ(scene.materials[0].normalTexture.image, scene.materials[1].normalTexture.image);
}

}  // namespace
}  // namespace vitrine
