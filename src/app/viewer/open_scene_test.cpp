// SPDX-License-Identifier: MIT
#include "app/viewer/open_scene.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace vitrine {
namespace {

TEST(OpenScene, TakesScenesModelsAndFieldsByTheirNames) {
    for (const char* file : {"a.toml", "/b c/a.glb", "a.gltf", "a.obj", "a.sdf.glsl"})
        EXPECT_TRUE(canOpen(file)) << file;
    for (const char* file : {"a.png", "a.mat.glsl", "a.glsl", "a.toml.txt", "toml", ""})
        EXPECT_FALSE(canOpen(file)) << file;
}

TEST(OpenScene, TellsNumbersFromWhatMustBeReadAgain) {
    EXPECT_TRUE(changesOnlyNumbers({"node.a.at=[0,0,0]"}, {"node.a.at=[1,0,0]", "render.ao=1"}));
    EXPECT_FALSE(changesOnlyNumbers({}, {"environment.turbidity=3"}));
    EXPECT_FALSE(changesOnlyNumbers({"shape.a.box.size=1"}, {}));
}

namespace fs = std::filesystem;
using Change = OpenScene::Change;

/// A scene in a folder, and who reads it when the test says so.
class OpenSceneTest : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(folder_);
        write("scene.toml", kText);
        write("ball.sdf.glsl", kBall);
        EXPECT_TRUE(answer(scene_.request()));
    }
    void TearDown() override { fs::remove_all(folder_); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder_ / name).string();
    }
    LoadResult read(const LoadRequest& request) { return loadFor(request, prober_, cache_); }
    bool answer(const LoadRequest& request) { return scene_.take(read(request), {}); }
    [[nodiscard]] float exposure() const { return scene_.loaded().scene.render.exposure; }

    static constexpr const char* kText =
        "[shape.ball]\nsdf = \"ball.sdf.glsl\"\n[shape.box]\nbox = { size = 1 }\n"
        "[[node]]\nshape = \"ball\"\n[[node]]\nshape = \"box\"\n";
    static constexpr const char* kBall =
        "// bounds[-1, -1, -1,  1, 1, 1]\n// lipschitz[1]\n"
        "float sdf(vec3 p) { return length(p) - 1.0; }\n";
    fs::path folder_ = fs::temp_directory_path() / ("vitrine-open-" + std::to_string(::getpid()));
    FieldProber prober_;
    SceneCache cache_;
    OpenScene scene_{path("scene.toml"), {"render.ao=0.5"}};
};

TEST_F(OpenSceneTest, NumbersAreTakenAtOnceAndTheRestIsToBeRead) {
    EXPECT_EQ(scene_.follow(true), Change::kNone);
    scene_.edits.set("render.exposure", "1");
    EXPECT_EQ(scene_.follow(true), Change::kNumbers);
    EXPECT_EQ(exposure(), 1);
    scene_.edits.set("shape.box.box", "{ size = 2 }");
    EXPECT_EQ(scene_.follow(true), Change::kMustRead);
    const LoadRequest request = scene_.request();
    EXPECT_EQ(request.overrides.size(), 3u) << "the command line's and both edits";
    EXPECT_EQ(scene_.follow(true), Change::kNone) << "it has been asked for";
    EXPECT_TRUE(answer(request));
    EXPECT_EQ(scene_.follow(true), Change::kNone);
    EXPECT_EQ(scene_.loaded().scene.shapes[1].box->size.x, 2);
}

TEST_F(OpenSceneTest, NumbersDoNotWaitForASnippetAndAreNotLostWithIt) {
    write("ball.sdf.glsl", std::string(kBall) + "\n");
    EXPECT_EQ(scene_.follow(true), Change::kMustRead);
    const LoadRequest request = scene_.request();
    EXPECT_TRUE(request.sameText);
    LoadResult result = read(request);
    scene_.edits.set("render.exposure", "1");
    EXPECT_EQ(scene_.follow(true), Change::kNumbers);
    EXPECT_EQ(exposure(), 1);
    EXPECT_TRUE(scene_.take(std::move(result), {}));
    EXPECT_EQ(scene_.follow(true), Change::kNumbers) << "what was read does not know them";
    EXPECT_EQ(exposure(), 1);
}

TEST_F(OpenSceneTest, NumbersWaitForAnotherText) {
    write("scene.toml", std::string("# another text\n") + kText);
    EXPECT_EQ(scene_.follow(true), Change::kMustRead);
    const LoadRequest request = scene_.request();
    EXPECT_FALSE(request.sameText);
    scene_.edits.set("render.exposure", "1");
    EXPECT_EQ(scene_.follow(true), Change::kNone);
    EXPECT_TRUE(answer(request));
    EXPECT_EQ(scene_.follow(true), Change::kNumbers);
    EXPECT_EQ(exposure(), 1);
}

TEST_F(OpenSceneTest, AMistakeStandsUntilItIsMendedAndTheSceneStays) {
    const auto good = scene_.shared();
    write("scene.toml", "[render");
    EXPECT_EQ(scene_.follow(true), Change::kMustRead);
    EXPECT_FALSE(answer(scene_.request()));
    EXPECT_TRUE(scene_.problems().hasErrors());
    EXPECT_EQ(scene_.shared(), good);
    EXPECT_EQ(scene_.follow(true), Change::kNone);
    write("scene.toml", kText);
    EXPECT_EQ(scene_.follow(true), Change::kMustRead);
    // What its snippets' compiler says counts as well.
    Diagnostics ofTheCompiler;
    ofTheCompiler.error({"ball.sdf.glsl"}, "no");
    EXPECT_FALSE(scene_.take(read(scene_.request()), ofTheCompiler));
    EXPECT_EQ(scene_.shared(), good);
    EXPECT_TRUE(answer(scene_.request()));
    EXPECT_FALSE(scene_.problems().hasErrors());
}

TEST_F(OpenSceneTest, AnAnswerThatCameLateIsNotTheLastWord) {
    scene_.edits.set("shape.box.box", "{ size = 2 }");
    const LoadRequest first = scene_.request();
    scene_.edits.set("shape.box.box", "{ size = 3 }");
    EXPECT_EQ(scene_.follow(true), Change::kMustRead);
    const LoadRequest second = scene_.request();
    EXPECT_TRUE(answer(first)) << "somebody who drags sees something";
    EXPECT_TRUE(scene_.isWaiting());
    EXPECT_EQ(scene_.follow(true), Change::kNone) << "but what he did last is on its way";
    EXPECT_TRUE(answer(second));
    EXPECT_FALSE(scene_.isWaiting());
    EXPECT_EQ(scene_.loaded().scene.shapes[1].box->size.x, 3);
}

TEST_F(OpenSceneTest, AnotherFileIsTakenWholeOrNotAtAll) {
    scene_.edits.set("render.exposure", "1");
    (void)scene_.follow(true);
    write("other.toml", "[render");
    EXPECT_FALSE(answer(OpenScene::requestFor(path("other.toml"))));
    EXPECT_EQ(scene_.file(), path("scene.toml"));
    EXPECT_FALSE(scene_.edits.empty());
    EXPECT_FALSE(scene_.problems().hasErrors()) << "nothing is wrong with this one";
    write("other.toml", kText);
    EXPECT_TRUE(answer(OpenScene::requestFor(path("other.toml"))));
    EXPECT_EQ(scene_.file(), path("other.toml"));
    EXPECT_TRUE(scene_.edits.empty());
    EXPECT_TRUE(scene_.overrides().empty());
    EXPECT_EQ(scene_.follow(true), Change::kNone);
    write("other.toml", std::string(kText) + "\n");
    EXPECT_EQ(scene_.follow(true), Change::kMustRead) << "it is watched";
}

TEST_F(OpenSceneTest, NumbersOfABareFieldAreTakenAtOnceToo) {
    OpenScene bare(path("ball.sdf.glsl"), {});
    ASSERT_TRUE(bare.take(read(bare.request()), {}));
    bare.edits.set("render.exposure", "1");
    EXPECT_EQ(bare.follow(true), Change::kNumbers);
    EXPECT_EQ(bare.loaded().scene.render.exposure, 1);
    (void)bare.momentWithoutEdits(0);
    EXPECT_EQ(bare.posedWithoutEdits().render.exposure, 0);
    bare.edits.set("environment.turbidity", "3");
    EXPECT_EQ(bare.follow(true), Change::kMustRead);
}

TEST_F(OpenSceneTest, KnowsWhatThereIsToPlay) {
    EXPECT_EQ(scene_.timeSpan(0).seconds, 0);
    write("ball.sdf.glsl",
          "// bounds[-2, -2, -2,  2, 2, 2]\n// lipschitz[1]\n"
          "float sdf(vec3 p) { return length(p) - 1.0 - 0.1 * sin(time); }\n");
    ASSERT_EQ(scene_.follow(true), Change::kMustRead);
    ASSERT_TRUE(answer(scene_.request()));
    const TimeSpan snippets = scene_.timeSpan(0);
    EXPECT_GT(snippets.seconds, 0);
    EXPECT_TRUE(snippets.endless);
    EXPECT_FALSE(snippets.hasKeys);
    write("scene.toml", std::string("[[camera]]\n[[camera]]\norbit = { period = 7 }\n") + kText +
                            "[[animation]]\nparam = \"render.exposure\"\n"
                            "keys = [[0, 0], [3, 1]]\n");
    write("ball.sdf.glsl", kBall);
    ASSERT_EQ(scene_.follow(true), Change::kMustRead);
    ASSERT_TRUE(answer(scene_.request()));
    EXPECT_EQ(scene_.timeSpan(0).seconds, 3) << "the orbit is the other camera's";
    EXPECT_FALSE(scene_.timeSpan(0).endless);
    EXPECT_EQ(scene_.timeSpan(1).seconds, 7);
    EXPECT_TRUE(scene_.timeSpan(1).endless);
    EXPECT_FALSE(scene_.moves(0));
    EXPECT_TRUE(scene_.moves(1));
    EXPECT_FALSE(scene_.movesAlone(1));
    write("scene.toml", std::string("[[camera]]\norbit = { period = 7 }\n") + kText);
    ASSERT_EQ(scene_.follow(true), Change::kMustRead);
    ASSERT_TRUE(answer(scene_.request()));
    EXPECT_TRUE(scene_.movesAlone(0));
}

}  // namespace
}  // namespace vitrine
