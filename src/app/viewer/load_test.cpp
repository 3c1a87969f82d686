// SPDX-License-Identifier: MIT
#include "app/viewer/load.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "image/png.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

class LoadTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("vitrine-load-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        write("scene.toml", R"([shape.a]
mesh = "a.obj"
[shape.b]
mesh = "b.obj"
[shape.box]
box = { size = 1 }
[shape.ball]
sdf = "ball.sdf.glsl"
[material.wood]
base_color_texture = "wood.png"
[[node]]
shape = "a"
material = "wood"
[[node]]
shape = "b"
[[node]]
shape = "box"
[[node]]
shape = "ball"
)");
        write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("b.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
        write("ball.sdf.glsl", ball("1.0"));
        writeFileAtomically(folder_ / "wood.png", encodePng(ImageRgba8(2, 2), {}));
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Measured and bounded: nobody needs a GPU for it.
    static std::string ball(const std::string& radius) {
        return "// bounds[-1, -1, -1,  1, 1, 1]\n// lipschitz[1]\nfloat sdf(vec3 p) { return "
               "length(p) - " +
               radius + "; }\n";
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    LoadResult load(const std::vector<std::string>& overrides = {}) {
        LoadRequest request;
        request.file = (folder_ / "scene.toml").string();
        request.overrides = overrides;
        LoadResult result = loadFor(request, prober_, cache_);
        trees_ = cache_.assets.trees.made() - treesBefore_;
        pictures_ = cache_.assets.pictures.made() - picturesBefore_;
        treesBefore_ += trees_;
        picturesBefore_ += pictures_;
        return result;
    }
    [[nodiscard]] bool watches(const LoadResult& result, const std::string& name) const {
        return result.files.count(folder_ / name) == 1;
    }

    fs::path folder_;
    FieldProber prober_;
    SceneCache cache_;
    int trees_ = 0, pictures_ = 0;  ///< made by the last load()
    int treesBefore_ = 0, picturesBefore_ = 0;
};

TEST_F(LoadTest, OnlyWhatHasChangedIsMadeAgain) {
    const LoadResult first = load();
    ASSERT_NE(first.scene, nullptr) << first.problems.text();
    EXPECT_EQ(trees_, 3);
    EXPECT_EQ(pictures_, 1);

    write("ball.sdf.glsl", ball("0.75"));
    const LoadResult snippet = load();
    ASSERT_NE(snippet.scene, nullptr);
    EXPECT_EQ(trees_, 0) << "a snippet builds no tree";
    EXPECT_EQ(pictures_, 0);
    EXPECT_EQ(snippet.scene->assets.meshes[0], first.scene->assets.meshes[0]);
    const auto ballOf = [](const LoadResult& result) {
        return result.scene->packed.fieldSnippets.front()->source;
    };
    EXPECT_NE(ballOf(snippet), ballOf(first));
    for (const char* file : {"scene.toml", "a.obj", "b.obj", "ball.sdf.glsl", "wood.png"})
        EXPECT_TRUE(watches(snippet, file)) << file;

    write("b.obj", "v 0 0 0\nv 3 0 0\nv 0 3.5 0\nf 1 2 3\n");
    const LoadResult mesh = load();
    ASSERT_NE(mesh.scene, nullptr);
    EXPECT_EQ(trees_, 1) << "a mesh builds one tree";
    EXPECT_EQ(pictures_, 0);
    EXPECT_EQ(mesh.scene->assets.meshes[1]->mesh->positions[1].x, 3);

    (void)load({"shape.box.box={size=2}"});
    EXPECT_EQ(trees_, 1) << "and so does a shape of another size";
    (void)load({"bvh.max_leaf_size=2"});
    EXPECT_EQ(trees_, 3) << "but all trees, if they are to be others";
}

TEST_F(LoadTest, AMistakeForgetsNothingAndIsToldEachTime) {
    (void)load();
    write("a.obj", "f 1 2 3\n");
    for (int i = 0; i < 2; ++i) {
        const LoadResult broken = load();
        EXPECT_EQ(broken.scene, nullptr);
        EXPECT_TRUE(broken.problems.hasErrors());
        EXPECT_TRUE(watches(broken, "a.obj"));
        EXPECT_TRUE(watches(broken, "b.obj"));
    }
    write("scene.toml", "[render");
    EXPECT_EQ(load().scene, nullptr);
    SetUp();
    const LoadResult mended = load();
    ASSERT_NE(mended.scene, nullptr) << mended.problems.text();
    // Written again, all of it, but for the box.
    EXPECT_EQ(trees_, 2);
    fs::remove(folder_ / "wood.png");
    const LoadResult missing = load();
    EXPECT_EQ(missing.scene, nullptr) << "a picture that is kept stands in for none that is gone";
    EXPECT_TRUE(watches(missing, "wood.png"));
}

}  // namespace
}  // namespace vitrine
