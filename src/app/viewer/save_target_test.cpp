// SPDX-License-Identifier: MIT
#include "app/viewer/save_target.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

class SaveTargetTest : public testing::Test {
  protected:
    SaveTargetTest() {
        fs::create_directories(folder_ / "below");
        fs::create_directory_symlink("below", folder_ / "link");
        fs::create_directory_symlink(".", folder_ / "here");
        std::ofstream(folder_ / "a.toml") << "x";
    }
    ~SaveTargetTest() override { fs::remove_all(folder_); }
    [[nodiscard]] SaveTarget target(const std::string& typed) const {
        return saveTarget((folder_ / "a.toml").string(), typed);
    }
    fs::path folder_ = fs::temp_directory_path() / ("vitrine-save-" + std::to_string(::getpid()));
};

TEST_F(SaveTargetTest, IsInTheScenesFolderAndEndsAsScenesDo) {
    for (const std::string& typed :
         {std::string("b"), std::string("b.toml"), std::string("./b"), folder_.string() + "/b.toml",
          std::string("below/../b"), std::string("here/b")}) {
        const SaveTarget t = target(typed);
        EXPECT_EQ(t.problem, "") << typed;
        EXPECT_EQ(fs::path(t.file).filename(), "b.toml") << typed;
        EXPECT_TRUE(fs::equivalent(fs::path(t.file).parent_path(), folder_)) << t.file;
        EXPECT_FALSE(t.exists);
    }
    EXPECT_EQ(fs::path(target("b.glb").file).filename(), "b.glb.toml");
}

TEST_F(SaveTargetTest, IsRefusedWhereReferencesWouldBreak) {
    for (const char* typed :
         {"below/b", "../b", "/tmp/b.toml", "link/b", "missing/b", "", "below/", "b\n"}) {
        const SaveTarget t = target(typed);
        EXPECT_EQ(t.file, "") << typed;
        EXPECT_NE(t.problem, "") << typed;
    }
    fs::create_directory(folder_ / "f.toml");
    EXPECT_NE(target("f").problem, "");
}

TEST_F(SaveTargetTest, TellsWhatIsThere) {
    EXPECT_TRUE(target("a").exists);
    fs::create_symlink("nowhere", folder_ / "lost.toml");
    EXPECT_TRUE(target("lost").exists);
}

TEST_F(SaveTargetTest, ProposesAFreeName) {
    EXPECT_EQ(freeSceneName((folder_ / "a.toml").string()), "a-2.toml");
    EXPECT_EQ(freeSceneName((folder_ / "a.glb").string()), "a-2.toml");
    EXPECT_EQ(freeSceneName((folder_ / "b.sdf.glsl").string()), "b.toml");
    std::ofstream(folder_ / "a-2.toml") << "x";
    EXPECT_EQ(freeSceneName((folder_ / "a.toml").string()), "a-3.toml");
}

}  // namespace
}  // namespace vitrine
