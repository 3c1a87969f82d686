// SPDX-License-Identifier: MIT
#include "app/viewer/recent_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "app/viewer/user_folders.hpp"
#include "base/file.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

class RecentFilesTest : public testing::Test {
  protected:
    RecentFilesTest() { fs::create_directories(folder_); }
    ~RecentFilesTest() override { fs::remove_all(folder_); }
    std::string touch(const std::string& name) {
        std::ofstream(folder_ / name) << "x";
        return (folder_ / name).string();
    }
    fs::path folder_ = fs::temp_directory_path() / ("vitrine-recent-" + std::to_string(::getpid()));
    fs::path list_ = folder_ / "a" / "b" / "recent";
};

TEST_F(RecentFilesTest, RemembersTheLastOneFirstAndEachOnce) {
    const std::string a = touch("a.toml"), b = touch("b.glb");
    RecentFiles recent(list_);
    recent.add(a);
    recent.add(b);
    recent.add(folder_.string() + "/./a.toml");
    EXPECT_EQ(recent.files(), (Paths{a, b}));
    EXPECT_EQ(RecentFiles(list_).files(), (Paths{a, b}));
}

TEST_F(RecentFilesTest, TakesWhatAnotherWindowHasAdded) {
    const std::string a = touch("a.toml"), b = touch("b.toml"), c = touch("c.toml");
    RecentFiles one(list_), other(list_);
    one.add(a);
    other.add(b);
    one.add(c);
    EXPECT_EQ(one.files(), (Paths{c, b, a}));
}

TEST_F(RecentFilesTest, KeepsTwelve) {
    RecentFiles recent(list_);
    for (int i = 0; i < 20; ++i) recent.add(touch(std::to_string(i) + ".toml"));
    ASSERT_EQ(RecentFiles(list_).files().size(), RecentFiles::kMost);
    EXPECT_EQ(recent.files().front(), (folder_ / "19.toml").string());
    EXPECT_EQ(recent.files().back(), (folder_ / "8.toml").string());
}

TEST_F(RecentFilesTest, ShowsOnlyWhatIsThereAndForgetsNothingForThat) {
    const std::string a = touch("a.toml"), b = touch("b.toml");
    RecentFiles recent(list_);
    recent.add(a);
    fs::remove(a);
    recent.add(b);
    EXPECT_EQ(recent.files(), Paths{b});
    touch("a.toml");
    recent.refresh();
    EXPECT_EQ(recent.files(), (Paths{b, a}));
}

TEST_F(RecentFilesTest, WorksWithoutAPlaceToWrite) {
    const std::string a = touch("a.toml"), b = touch("b.toml");
    for (const fs::path& list : {fs::path(), fs::path("/proc/vitrine/recent")}) {
        RecentFiles recent(list);
        recent.add(a);
        recent.add(b);
        EXPECT_EQ(recent.files(), (Paths{b, a})) << list;
        recent.refresh();
        EXPECT_EQ(recent.files(), (Paths{b, a})) << list;
    }
}

TEST(RecentFilesOf, SkipsWhatABrokenListHolds) {
    std::string zero = "/a/zero.toml";
    zero[3] = '\0';
    const std::string text = "relative.toml\n/a/b.toml\n\n/a/b.png\n" + zero +
                             "\n/a/b.toml\n/a/\x1b[2J.toml\n/" + std::string(5000, 'x') +
                             ".toml\n/c d/e.glb";
    EXPECT_EQ(recentFilesOf(text), (Paths{"/a/b.toml", "/c d/e.glb"}));
    EXPECT_TRUE(recentFilesOf("").empty());
    EXPECT_TRUE(recentFilesOf(std::string(1000, '\xff')).empty());
}

TEST(UserFolders, FollowTheVariablesIfTheyAreAbsolute) {
    const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    ::setenv("HOME", "/home/me", 1);
    ::setenv("XDG_STATE_HOME", "/state", 1);
    ::setenv("XDG_CACHE_HOME", "relative", 1);
    EXPECT_EQ(stateFolder(), "/state/vitrine");
    EXPECT_EQ(cacheFolder(), "/home/me/.cache/vitrine");
    ::unsetenv("XDG_STATE_HOME");
    ::unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(stateFolder(), "/home/me/.local/state/vitrine");
    ::unsetenv("HOME");
    EXPECT_EQ(cacheFolder(), "");
    if (!home.empty()) ::setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace vitrine
