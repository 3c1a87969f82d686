// SPDX-License-Identifier: MIT
#include "app/viewer/folder_list.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

TEST(FolderList, HoldsFoldersAndWhatCanBeOpened) {
    const fs::path folder =
        fs::temp_directory_path() / ("vitrine-list-" + std::to_string(::getpid()));
    fs::create_directories(folder / "zoo");
    fs::create_directories(folder / "a.toml");  // a folder whatever it is called
    fs::create_directories(folder / ".hidden");
    for (const char* name : {"b.toml", "a.glb", "notes.txt", ".b.toml", "f.sdf.glsl", "f.mat.glsl"})
        std::ofstream(folder / name) << "x";
    fs::create_symlink("nowhere", folder / "lost.toml");
    const FolderList list = listFolder(folder);
    EXPECT_EQ(list.folders, (Names{"a.toml", "zoo"}));
    EXPECT_EQ(list.files, (Names{"a.glb", "b.toml", "f.sdf.glsl"}));
    EXPECT_EQ(list.problem, "");
    fs::remove_all(folder);
    EXPECT_NE(listFolder(folder).problem, "");
}

TEST(FolderList, UnderstandsWhatIsTyped) {
    EXPECT_EQ(typedPath("/a/b", "c.toml"), "/a/b/c.toml");
    EXPECT_EQ(typedPath("/a/b", "../c.toml"), "/a/c.toml");
    EXPECT_EQ(typedPath("/a/b", "/c.toml"), "/c.toml");
    ::setenv("HOME", "/home/me", 1);
    EXPECT_EQ(typedPath("/a/b", "~/c.toml"), "/home/me/c.toml");
    EXPECT_EQ(typedPath("/a/b", "~c.toml"), "/a/b/~c.toml");
}

}  // namespace
}  // namespace vitrine
