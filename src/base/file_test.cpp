// SPDX-License-Identifier: MIT
#include "base/file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "base/error.hpp"

namespace vitrine {
namespace fs = std::filesystem;

class FileTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = fs::temp_directory_path() / "vitrine-file-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { fs::remove_all(folder); }
    fs::path folder;
};

TEST_F(FileTest, WritesAndReadsBack) {
    writeFileAtomically(folder / "a.txt", std::string_view("first"));
    writeFileAtomically(folder / "a.txt", std::string_view("second"));
    EXPECT_EQ(readFile(folder / "a.txt", 100), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "a temporary was left";
}

TEST_F(FileTest, RefusesWhatIsNotARegularFileOrTooLarge) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(readFile(folder / "pipe", 100), InputError);
    EXPECT_THROW(readFile(folder, 100), InputError);
    EXPECT_THROW(readFile(folder / "missing", 100), InputError);
    writeFileAtomically(folder / "big", std::string_view("0123456789"));
    EXPECT_NO_THROW(readFile(folder / "big", 10));
    EXPECT_THROW(readFile(folder / "big", 9), InputError);
}

TEST_F(FileTest, StaysInsideTheFolder) {
    fs::create_directory(folder / "scene");
    const fs::path root = folder / "scene";
    writeFileAtomically(folder / "secret", std::string_view("x"));
    fs::create_symlink(folder / "secret", root / "link");
    EXPECT_NO_THROW(resolveInside(root, "a/b.obj"));
    EXPECT_NO_THROW(resolveInside(root, "a/../b.obj"));
    EXPECT_NO_THROW(resolveInside(root, "..b.obj"));
    EXPECT_THROW(resolveInside(root, "../secret"), std::invalid_argument);
    EXPECT_THROW(resolveInside(root, "a/../../secret"), std::invalid_argument);
    EXPECT_THROW(resolveInside(root, "/etc/hostname"), std::invalid_argument);
    EXPECT_THROW(resolveInside(root, "link"), std::invalid_argument);
    EXPECT_THROW(resolveInside(root, ""), std::invalid_argument);
}

/// Exits with 3 if a write that fails part way is reported and leaves nothing. A limit on the file
/// size stands in for a full disk.
[[noreturn]] static void writeOnFullDisk(const fs::path& folder) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
        writeFileAtomically(folder / "big", std::string(5000, 'x'));
    } catch (const MachineError&) {
        std::_Exit(fs::is_empty(folder) ? 3 : 4);
    }
    std::_Exit(0);
}

TEST_F(FileTest, FullDiskIsAnErrorAndLeavesNothing) {
    EXPECT_EXIT(writeOnFullDisk(folder), testing::ExitedWithCode(3), "");
}

TEST_F(FileTest, WritesThroughLinksButOnNothingElse) {
    writeFileAtomically(folder / "a", std::string_view("old"));
    fs::create_symlink("a", folder / "link");
    writeFileAtomically(folder / "link", std::string_view("new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(readFile(folder / "a", 100), "new");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(writeFileAtomically(folder / "pipe", std::string_view("x")), MachineError);
    EXPECT_THROW(checkWritable(folder / "pipe"), MachineError);
    EXPECT_TRUE(fs::is_fifo(folder / "pipe")) << "a device would be lost in the same way";
}

TEST_F(FileTest, ChecksWritability) {
    EXPECT_NO_THROW(checkWritable(folder / "new.png"));
    EXPECT_THROW(checkWritable(folder), MachineError);
    EXPECT_THROW(checkWritable(folder / "no" / "new.png"), MachineError);
}

}  // namespace vitrine
