// SPDX-License-Identifier: MIT
#include "scene/edit_text.hpp"

#include <gtest/gtest.h>

#include "base/text.hpp"

namespace vitrine {
namespace {

const std::string kScene = R"(# A scène with a comment in every place
[scene]
title = "Tëst"   # behind

[render]   # header
    bounces = 2  # two
    exposure=0.5

[[camera]]
name = "a"
eye = [1, 2,   # x, y
       3]      # z
target = [0, 0, 0]

[[light]]
name = "ké"
intensity = 3
[[light]]
name = "rim"

[material.red]
base_color = "#ff0000"

[shape.ball]
sphere = { radius = 0.5 } # a ball
[shape.box]
box = {}

[[node]]
name = "one"
shape = "ball"
set = { morph = 0.25, tint = [1, 0, 0] }
  at = [0, 0, 0]

[[node]]
name = "last")";

std::string edit(const std::vector<std::string>& assignments, const std::string& text = kScene) {
    Diagnostics diagnostics;
    const std::string result = editSceneText(text, "t.toml", assignments, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    return result;
}

/// Lines that are not in both, as "-old" and "+new".
std::string difference(const std::string& a, const std::string& b) {
    const auto x = splitLines(a), y = splitLines(b);
    size_t head = 0, tail = 0;
    const size_t most = std::min(x.size(), y.size());
    while (head < most && x[head] == y[head]) ++head;
    while (tail < most - head && x[x.size() - 1 - tail] == y[y.size() - 1 - tail]) ++tail;
    std::string out;
    for (size_t i = head; i + tail < x.size(); ++i) out += "-" + std::string(x[i]) + "\n";
    for (size_t i = head; i + tail < y.size(); ++i) out += "+" + std::string(y[i]) + "\n";
    return out;
}

std::string differenceOf(const std::string& assignment) {
    return difference(kScene, edit({assignment}));
}

TEST(EditText, ReplacesAValueAndNothingElse) {
    EXPECT_EQ(differenceOf("render.bounces=5"),
              "-    bounces = 2  # two\n+    bounces = 5  # two\n");
    EXPECT_EQ(differenceOf("render.exposure=-1.25"), "-    exposure=0.5\n+    exposure=-1.25\n");
    EXPECT_EQ(differenceOf("scene.title=Näme \"x\""),
              "-title = \"Tëst\"   # behind\n+title = \"Näme \\\"x\\\"\"   # behind\n");
    EXPECT_EQ(differenceOf("light.ké.intensity=4"), "-intensity = 3\n+intensity = 4\n");
    EXPECT_EQ(differenceOf("camera.a.eye=[4, 5, 6]"),
              "-eye = [1, 2,   # x, y\n-       3]      # z\n+eye = [4, 5, 6]      # z\n");
    EXPECT_EQ(differenceOf("material.red.base_color=[0, 1, 0]"),
              "-base_color = \"#ff0000\"\n+base_color = [0, 1, 0]\n");
}

TEST(EditText, ReachesIntoInlineTables) {
    EXPECT_EQ(differenceOf("shape.ball.sphere.radius=2"),
              "-sphere = { radius = 0.5 } # a ball\n+sphere = { radius = 2 } # a ball\n");
    EXPECT_EQ(
        differenceOf("node.one.set.morph=1"),
        "-set = { morph = 0.25, tint = [1, 0, 0] }\n+set = { morph = 1, tint = [1, 0, 0] }\n");
    EXPECT_EQ(differenceOf("node.one.set.cells=7"),
              "-set = { morph = 0.25, tint = [1, 0, 0] }\n"
              "+set = { morph = 0.25, tint = [1, 0, 0], cells = 7 }\n");
    EXPECT_EQ(differenceOf("shape.box.box.size=2"), "-box = {}\n+box = { size = 2 }\n");
}

TEST(EditText, AddsKeysBehindTheLastOfTheirTable) {
    EXPECT_EQ(differenceOf("render.gamma=1.2"), "+    gamma = 1.2\n");
    EXPECT_EQ(differenceOf("light.rim.color=[1, 0, 0]"), "+color = [1, 0, 0]\n");
    EXPECT_EQ(differenceOf("node.one.rotate=[0, 9, 0]"), "+  rotate = [0, 9, 0]\n");
    EXPECT_EQ(difference(kScene + "\n", edit({"node.last.set.morph=1"})), "+set = { morph = 1 }\n");
    EXPECT_EQ(edit({"render.bounces=1"}, "[render]"), "[render]\nbounces = 1\n");
}

TEST(EditText, AddsMissingSections) {
    EXPECT_EQ(difference(kScene, edit({"environment.intensity=2"})),
              "+\n+[environment]\n+intensity = 2\n");
    EXPECT_EQ(edit({"render.bounces=1", "render.gamma=2"}, ""),
              "\n[render]\nbounces = 1\ngamma = 2\n");
}

TEST(EditText, LeavesWhatIsThereAlready) {
    EXPECT_EQ(edit({"render.bounces=2", "scene.title=Tëst"}), kScene);
}

TEST(EditText, SaysWhatCannotBeWritten) {
    Diagnostics diagnostics;
    EXPECT_EQ(editSceneText(kScene, "t.toml", {"node.nobody.at=[1,2,3]", "render.bounces=9"},
                            diagnostics),
              edit({"render.bounces=9"}));
    EXPECT_NE(diagnostics.text().find("the scene has no node 'nobody'"), std::string::npos);
    Diagnostics broken;
    EXPECT_EQ(editSceneText("[render", "t.toml", {"render.bounces=9"}, broken), "[render");
    EXPECT_TRUE(broken.hasErrors());
}

}  // namespace
}  // namespace vitrine
