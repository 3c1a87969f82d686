// SPDX-License-Identifier: MIT
#include "scene/include.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "scene/test_scene.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

/// Files in a folder of their own; messages name them without it.
class Include : public testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            fs::temp_directory_path() /
            fmt::format("vitrine-include-{}", testing::UnitTest::GetInstance()->random_seed() +
                                                  static_cast<int>(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "s" / "parts" / "deep");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / "s" / name) << text;
    }
    Scene load(const std::vector<std::string>& overrides = {}) {
        problems_ = {};
        Scene scene = loadScene(folder_ / "s" / "top.toml", overrides, problems_);
        return scene;
    }
    std::string problems() {
        (void)load();
        std::string text = problems_.text();
        const std::string prefix = (folder_ / "s").string() + "/";
        for (size_t at = 0; (at = text.find(prefix)) != std::string::npos;)
            text.erase(at, prefix.size());
        return text;
    }

    fs::path folder_;
    Diagnostics problems_;
};

TEST_F(Include, AddsEverythingButTheTitle) {
    write("top.toml",
          "[scene]\ntitle = \"Top\"\ninclude = [\"parts/a.toml\"]\n[render]\nao = 2\n"
          "[[camera]]\nname = \"own\"\n[[node]]\nname = \"n\"\nparent = \"m\"\n");
    write("parts/a.toml",
          "[scene]\ntitle = \"Part\"\n[render]\nao = 3\ngamma = 1.5\n[environment]\nsky = [1,2,3]\n"
          "[[camera]]\nname = \"other\"\n[[light]]\nname = \"sun\"\n[material.red]\n"
          "base_color_texture = \"red.png\"\nsnippet = \"deep/x.mat.glsl\"\n"
          "[shape.s]\nmesh = \"../s.obj\"\n[[node]]\nname = \"m\"\nshape = \"s\"\n"
          "[[animation]]\nnode = \"m\"\nparam = \"at\"\nkeys = [[0, [0, 1, 0]]]\n");
    const Scene scene = load({"node.m.visible=false", "material.red.roughness=0.125"});
    EXPECT_EQ(problems_.text(), "");
    EXPECT_EQ(scene.title, "Top");
    EXPECT_EQ(scene.render.ao, 2);
    EXPECT_EQ(scene.render.gamma, 1.5f);
    EXPECT_EQ(scene.environment.zenith.rgb, glm::vec3(1, 2, 3));
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "own");
    EXPECT_EQ(scene.lights.at(0).name, "sun");
    EXPECT_EQ(scene.nodes.at(1).name, "m");
    EXPECT_FALSE(scene.nodes[1].visible);
    EXPECT_EQ(scene.animations.at(0).target.index, 1u);
    EXPECT_EQ(scene.materials.at(0).roughness, 0.125f);
    EXPECT_EQ(scene.materials[0].baseColorTexture.file.name, "parts/red.png");
    EXPECT_EQ(scene.materials[0].snippet.name, "parts/deep/x.mat.glsl");
    EXPECT_EQ(scene.shapes.at(0).mesh.name, "s.obj");
    EXPECT_EQ(scene.nodes[1].shape.name, "s") << "no file";
}

TEST_F(Include, FilesThatItNamesAreBesideIt) {
    write("top.toml", "[scene]\ninclude = [\"parts/a.toml\"]\n");
    write("parts/a.toml",
          "[scene]\ninclude = [\"deep/b.toml\"]\n[environment]\nsky = \"x.hdr\"\n"
          "[[node]]\nname = \"near\"\ninclude = \"near.glb\"\n");
    write("parts/deep/b.toml",
          "[[node]]\nname = \"deep\"\ninclude = \"../../far.glb\"\nscale = [-2, 2, 2]\n"
          "[shape.s]\nsdf = \"s.sdf.glsl\"\n[material.m]\nnormal_texture = \"n.png\"\n"
          "sheen_color_texture = \"../sheen.png\"\n");
    const Scene scene = load();
    EXPECT_EQ(problems_.text(), "");
    EXPECT_EQ(scene.environment.picture.name, "parts/x.hdr");
    EXPECT_EQ(scene.nodes.at(0).include.name, "parts/near.glb");
    EXPECT_EQ(scene.nodes.at(1).include.name, "far.glb");
    EXPECT_EQ(scene.nodes[1].scale, glm::vec3(-2, 2, 2));
    EXPECT_EQ(scene.shapes.at(0).sdf.name, "parts/deep/s.sdf.glsl");
    EXPECT_EQ(scene.materials.at(0).normalTexture.file.name, "parts/deep/n.png");
    EXPECT_EQ(scene.materials[0].sheenColorTexture.file.name, "parts/sheen.png");
    EXPECT_EQ(load({"environment.sky=\"y.hdr\""}).environment.picture.name, "y.hdr");
    EXPECT_EQ(load({"node.near.include=\"y.glb\""}).nodes.at(0).include.name, "y.glb");
}

TEST_F(Include, FilesThatSetNamesAreTheScenesOwn) {
    write("top.toml", "[scene]\ninclude = [\"parts/a.toml\"]\n");
    write("parts/a.toml", "[shape.s]\nmesh = \"a.obj\"\n");
    EXPECT_EQ(load({"shape.s.mesh=b.obj"}).shapes.at(0).mesh.name, "b.obj");
    EXPECT_EQ(load({"scene.include=[\"x.toml\"]"}).shapes.size(), 1u);
    EXPECT_NE(problems_.text().find("what is included stands in the scene"), std::string::npos);
}

TEST_F(Include, IsRelativeToItsOwnFileAndTakenOnce) {
    write("top.toml", "[scene]\ninclude = [\"parts/a.toml\", \"parts/deep/b.toml\"]\n");
    write("parts/a.toml", "[scene]\ninclude = [\"deep/b.toml\"]\n[[node]]\nname = \"a\"\n");
    write("parts/deep/b.toml", "[scene]\ninclude = [\"../../c.toml\"]\n[[node]]\nname = \"b\"\n");
    write("c.toml", "[[node]]\nname = \"c\"\n");
    EXPECT_EQ(problems(), "");
    EXPECT_EQ(load().nodes.size(), 3u);
}

TEST_F(Include, NamesThatClashAreGivenWithBothPlaces) {
    write("top.toml",
          "[scene]\ninclude = [\"a.toml\", \"b.toml\"]\n[material.x]\n[[node]]\nname = \"n\"\n");
    write("a.toml", "[material.x]\n[render]\nao = 1\n[environment]\nintensity = 2\n");
    write("b.toml", "[[node]]\nname = \"n\"\n[render]\nao = 1\n[environment]\n");
    EXPECT_EQ(problems(),
              "a.toml:1:11: error: two materials are named 'x'; the other is at top.toml:3:11\n"
              "b.toml:1:1: error: two nodes are named 'n'; the other is at top.toml:4:1\n"
              "b.toml:4:1: error: ao is given already, at a.toml:3:1\n"
              "b.toml:5:2: error: there is an environment already, at a.toml:4:1");
}

TEST_F(Include, CirclesEnd) {
    write("top.toml", "[scene]\ninclude = [\"parts/a.toml\"]\n");
    write("parts/a.toml", "[scene]\ninclude = [\"../top.toml\"]\n");
    EXPECT_EQ(problems(), "parts/a.toml:2:12: error: '../top.toml': this file includes itself");
    write("top.toml", "[scene]\ninclude = [\"top.toml\"]\n");
    EXPECT_EQ(problems(), "top.toml:2:12: error: 'top.toml': this file includes itself");
}

TEST_F(Include, DepthAndNumberAreBounded) {
    const auto chain = [&](int files) {
        for (int i = 0; i < files; ++i)
            write(i == 0 ? "top.toml" : fmt::format("{}.toml", i),
                  i + 1 < files ? fmt::format("[scene]\ninclude = [\"{}.toml\"]\n", i + 1)
                                : "[[node]]\n");
    };
    chain(kMaxIncludeDepth + 1);
    EXPECT_EQ(problems(), "");
    chain(kMaxIncludeDepth + 2);
    EXPECT_EQ(problems(),
              "16.toml:2:12: error: '17.toml': files include each other more than 16 deep");
    std::string names;
    for (size_t i = 0; i <= kMaxIncludes; ++i) {
        write(fmt::format("n{}.toml", i), "");
        names += fmt::format("\"n{}.toml\",\n", i);
    }
    write("top.toml", "[scene]\ninclude = [\n" + names + "]\n");
    EXPECT_EQ(problems(), "top.toml:67:1: error: 'n64.toml': more than 64 files are included");
}

TEST_F(Include, NothingOutsideOfTheScenesFolderIsRead) {
    std::ofstream(folder_ / "secret.toml") << "[[node]]\nname = \"secret\"\n";
    fs::create_symlink(folder_ / "secret.toml", folder_ / "s" / "link.toml");
    const std::string absolute = (folder_ / "secret.toml").string();
    for (const std::string& name :
         {std::string("../secret.toml"), std::string("parts/../../secret.toml"),
          std::string("link.toml"), absolute}) {
        write("top.toml", "[scene]\ninclude = [\"" + name + "\"]\n");
        EXPECT_EQ(problems().find("top.toml:2:12: error: '"), 0u) << name << problems();
        EXPECT_TRUE(load().nodes.empty()) << name;
    }
}

TEST_F(Include, MistakesStandWhereTheyAre) {
    write("top.toml",
          "[scene]\ninclude = [\"a.toml\", \"no.toml\", \"a.obj\", 5]\n[[node]]\nx = 1\n");
    write("a.toml", "\n[[node]]\ny = 1\n");
    EXPECT_EQ(problems(),
              "top.toml:2:22: error: 'no.toml': cannot read: No such file or directory\n"
              "top.toml:2:33: error: 'a.obj': an included file is a scene (.toml)\n"
              "top.toml:2:42: error: an included file is a name in quotes\n"
              "top.toml:4:1: error: unknown key 'x' in [[node]]\n"
              "a.toml:3:1: error: unknown key 'y' in [[node]]");
    write("a.toml", "[[node\n");
    write("top.toml", "[scene]\ninclude = [\"a.toml\"]\n");
    EXPECT_EQ(problems().find("a.toml:1:7: error: "), 0u) << problems();
    write("top.toml", "[scene]\ninclude = \"a.toml\"\n");
    EXPECT_EQ(problems(),
              "top.toml:2:11: error: include must be a list, as in [\"parts/hall.toml\"]");
}

}  // namespace
}  // namespace vitrine
