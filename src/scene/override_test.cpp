// SPDX-License-Identifier: MIT
// `--set KEY=VALUE`.
#include <gtest/gtest.h>

#include "scene/test_scene.hpp"

namespace vitrine {
namespace {

constexpr const char* kScene = R"([render]
exposure = 1
[[camera]]
name = "front"
[[camera]]
name = "side"
[[light]]
name = "key"
[[light]]
name = "rim"
[material.gold]
roughness = 0.3
[material."dark red"]
[shape.crate]
box = { size = 1 }
[shape.ball]
sphere = { radius = 1 }
[shape.field]
sdf = "f.sdf.glsl"
[[node]]
name = "left"
shape = "field"
[[node]]
name = "right"
shape = "ball"
)";

Scene with(const std::string& assignment) {
    return goodScene(kScene, {assignment});
}
std::string problem(const std::string& assignment) {
    return problemsOf(kScene, {assignment});
}

TEST(Override, SectionsThereIsOneOf) {
    EXPECT_EQ(with("render.exposure=2.5").render.exposure, 2.5f) << "replaces";
    EXPECT_EQ(with("render.samples=12").render.samples, 12) << "adds";
    EXPECT_EQ(with("environment.intensity=3").environment.intensity, 3) << "adds the section";
    EXPECT_EQ(with("scene.title=New").title, "New");
}

TEST(Override, Cameras) {
    const Scene first = with("camera.fov=40");
    EXPECT_EQ(first.cameras[0].fov, 40);
    EXPECT_EQ(first.cameras[1].fov, 0) << "only the first one without a name";
    const Scene side = with("camera.side.fov=40");
    EXPECT_EQ(side.cameras[0].fov, 0);
    EXPECT_EQ(side.cameras[1].fov, 40);
}

TEST(Override, Lights) {
    const Scene all = with("light.intensity=0.5");
    EXPECT_EQ(all.lights[0].intensity, 0.5f);
    EXPECT_EQ(all.lights[1].intensity, 0.5f) << "every light without a name";
    const Scene rim = with("light.rim.intensity=0.5");
    EXPECT_EQ(rim.lights[0].intensity, Light{}.intensity);
    EXPECT_EQ(rim.lights[1].intensity, 0.5f);
}

TEST(Override, NamedSections) {
    const Scene gold = with("material.gold.roughness=0.9");
    EXPECT_EQ(gold.materials[1].name, "gold");
    EXPECT_EQ(gold.materials[1].roughness, 0.9f);
    EXPECT_EQ(with("material.dark red.metallic=1").materials[0].metallic, 1);
    EXPECT_EQ(with("shape.ball.sphere.radius=4").shapes[0].sphere->radius, 4) << "inside a table";
    EXPECT_EQ(with("shape.crate.box.size=[1,2,3]").shapes[1].box->size, glm::vec3(1, 2, 3));
}

TEST(Override, Nodes) {
    EXPECT_EQ(with("node.right.at=[1, 2, 3]").nodes[1].at, glm::vec3(1, 2, 3));
    EXPECT_EQ(with("node.right.visible=false").nodes[1].visible, false);
    const Scene set = with("node.left.set.tilt=60");
    ASSERT_EQ(set.nodes[0].set.size(), 1u);
    EXPECT_EQ(set.nodes[0].set[0].name, "tilt");
    EXPECT_EQ(set.nodes[0].set[0].value.x, 60);
    EXPECT_EQ(set.nodes[0].set[0].where.text(), "--set node.left.set.tilt=60");
    const Scene parts = with("node.left.parts.lid=gold");
    ASSERT_EQ(parts.nodes[0].parts.size(), 1u);
    EXPECT_EQ(parts.nodes[0].parts[0].second.name, "gold");
    EXPECT_EQ(parts.nodes[0].partPlaces[0].text(), "--set node.left.parts.lid=gold");
}

TEST(Override, SpellingsOfValues) {
    EXPECT_EQ(with("render.tone_map=none").render.toneMap, ToneMap::kNone) << "bare word";
    EXPECT_EQ(with("render.tone_map=\"none\"").render.toneMap, ToneMap::kNone);
    EXPECT_EQ(with("render.tone_map='none'").render.toneMap, ToneMap::kNone);
    EXPECT_EQ(with("environment.sky=[0.1,0.2,0.3]").environment.ground.rgb,
              glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(with("environment.sky='#ffffff'").environment.zenith.rgb, glm::vec3(1));
    EXPECT_EQ(with("environment.sky=#ffffff").environment.zenith.rgb, glm::vec3(1))
        << "a shell takes the quotes away";
    EXPECT_EQ(with("scene.title=a=b c").title, "a=b c");
    EXPECT_EQ(with("scene.title=Don't").title, "Don't");
    EXPECT_EQ(with(" render . exposure = 3 ").render.exposure, 3) << "spaces around words";
}

TEST(Override, LastOneWins) {
    EXPECT_EQ(goodScene(kScene, {"render.exposure=2", "render.exposure=3"}).render.exposure, 3);
}

TEST(Override, MistakesNameTheAssignment) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "--set : error: write it as key=value"},
        {"render.exposure", "--set render.exposure: error: write it as key=value"},
        {"=1", "--set =1: error: write it as key=value"},
        {"exposure=1", "--set exposure=1: error: the key needs a section, as in render.exposure"},
        {"render.=1", "--set render.=1: error: the key needs a section, as in render.exposure"},
        {"rendr.exposure=1",
         "--set rendr.exposure=1: error: unknown section 'rendr' (did you mean 'render'?)"},
        {"render.expsure=1",
         "--set render.expsure=1: error: unknown key 'expsure' in [render] (did you mean "
         "'exposure'?)"},
        {"render.new.x=1", "--set render.new.x=1: error: unknown key 'new' in [render]"},
        {"render.gamma.x=1", "--set render.gamma.x=1: error: gamma must be a number"},
        {"render.exposure.x=1",
         "--set render.exposure.x=1: error: 'exposure' has no keys of its own"},
        {"render.exposure=bright",
         "--set render.exposure=bright: error: exposure must be a number"},
        {"render.exposure=99",
         "--set render.exposure=99: error: exposure is 99; it must be from -20 to 20"},
        {"render.exposure=nan", "--set render.exposure=nan: error: exposure must be finite"},
        {"camera.sid.fov=4",
         "--set camera.sid.fov=4: error: the scene has no camera 'sid' (did you mean 'side'?)"},
        {"material.roughness=1",
         "--set material.roughness=1: error: say which material: material.NAME.roughness"},
        {"node.at=[0,0,0]", "--set node.at=[0,0,0]: error: say which node: node.NAME.at"},
        {"node.lft.at=[0,0,0]",
         "--set node.lft.at=[0,0,0]: error: the scene has no node 'lft' (did you mean 'left'?)"},
        {"shape.ball.sphre.radius=1",
         "--set shape.ball.sphre.radius=1: error: unknown key 'sphre' in [shape.ball] (did you "
         "mean "
         "'sphere'?)"},
        {"node.left.shape=bal",
         "--set node.left.shape=bal: error: no shape is named 'bal' (did you mean 'ball'?)"},
    };
    for (const auto& [assignment, expected] : cases) EXPECT_EQ(problem(assignment), expected);
    EXPECT_EQ(problemsOf("", {"light.intensity=1"}),
              "--set light.intensity=1: error: the scene has no light");
    const std::string longKey = "render" + std::string(5000, '.') + "x=1";
    EXPECT_EQ(problem(longKey), "--set " + longKey + ": error: write it as key=value");
}

}  // namespace
}  // namespace vitrine
