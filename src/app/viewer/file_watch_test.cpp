// SPDX-License-Identifier: MIT
#include "app/viewer/file_watch.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

class FileWatchTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("vitrine-watch-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        a_ = folder_ / "a";
        b_ = folder_ / "b";
        write(a_, "one");
        watch_.watch({{a_, stampOf(a_)}, {b_, stampOf(b_)}});
    }
    void TearDown() override { fs::remove_all(folder_); }
    static void write(const fs::path& file, const std::string& text) {
        std::ofstream(file) << text;
    }
    using Files = std::set<fs::path>;
    fs::path folder_, a_, b_;
    FileWatch watch_;
};

TEST_F(FileWatchTest, NoticesEveryWayOfWriting) {
    EXPECT_EQ(watch_.changed(), Files{});
    write(a_, "longer");
    EXPECT_EQ(watch_.changed(), Files{a_});
    EXPECT_EQ(watch_.changed(), Files{});
    write(folder_ / "new", "LONGER");
    fs::rename(folder_ / "new", a_);
    EXPECT_EQ(watch_.changed(), Files{a_});
    write(b_, "it was not there");
    fs::remove(a_);
    EXPECT_EQ(watch_.changed(), (Files{a_, b_}));
    write(a_, "back");
    EXPECT_EQ(watch_.changed(), Files{a_});
}

TEST_F(FileWatchTest, ChangesWhileAFileIsReadAreNotLost) {
    const ReadRecord record;
    (void)readFile(a_, 100);
    write(a_, "changed after it was read, before anybody watches it");
    watch_.watch(record.files());
    EXPECT_EQ(watch_.changed(), Files{a_});
    write(b_, "nobody looks");
    EXPECT_EQ(watch_.changed(), Files{});
}

}  // namespace
}  // namespace vitrine
