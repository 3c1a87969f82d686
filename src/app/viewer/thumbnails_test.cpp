// SPDX-License-Identifier: MIT
#include "app/viewer/thumbnails.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/file.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

/// Of as many scenes as there are, whatever becomes of them.
std::vector<Thumbnails::Result> all(Thumbnails& thumbnails, size_t count) {
    std::vector<Thumbnails::Result> list;
    for (int i = 0; i < 400 && list.size() < count; ++i) {
        for (auto& result : thumbnails.take()) list.push_back(std::move(result));
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
    return list;
}

class ThumbnailsTest : public testing::Test {
  protected:
    ThumbnailsTest() { fs::create_directories(folder_ / "cache"); }
    ~ThumbnailsTest() override { fs::remove_all(folder_); }
    std::string scene(const std::string& name, const std::string& text) {
        writeFileAtomically(folder_ / name, text);
        return (folder_ / name).string();
    }
    /// A picture of a scene with this text, drawn from `file`.
    void keep(const std::string& text, const ImageRgba8& picture, const std::string& file) {
        const fs::path kept = folder_ / "cache" / thumbnailName(text, "1");
        writeFileAtomically(kept, encodePng(picture));
        writeFileAtomically(kept.string() + ".files", thumbnailFiles({{file, stampOf(file)}}));
    }
    fs::path folder_ = fs::temp_directory_path() / ("vitrine-thumbs-" + std::to_string(::getpid()));
};

TEST_F(ThumbnailsTest, AreTakenFromTheCacheWithoutDrawing) {
    ImageRgba8 picture(Thumbnails::kWidth, Thumbnails::kHeight);
    std::fill(picture.pixels.begin(), picture.pixels.end(), uint8_t{255});
    picture.at(3, 2)[1] = 7;
    const std::string snippet = scene("a.sdf.glsl", "one");
    keep("no scene at all", picture, snippet);  // nothing could be drawn of it
    Thumbnails thumbnails({scene("a.toml", "no scene at all")}, folder_ / "cache", "1");
    const auto results = all(thumbnails, 1);
    ASSERT_EQ(results.size(), 1u);
    EXPECT_EQ(results[0].picture, picture);

    scene("a.sdf.glsl", "another");
    Thumbnails later({scene("a.toml", "no scene at all")}, folder_ / "cache", "1");
    const auto drawnAnew = all(later, 1);
    ASSERT_EQ(drawnAnew.size(), 1u);
    EXPECT_TRUE(drawnAnew[0].picture.pixels.empty()) << "what it shows has changed";
}

TEST_F(ThumbnailsTest, AreEmptyForWhatCannotBeDrawn) {
    keep("broken", ImageRgba8(2, 2), scene("x", ""));  // of another size: not ours
    writeFileAtomically(folder_ / "cache" / thumbnailName("[broken", "1"), "no picture");
    Thumbnails thumbnails({scene("a.toml", "broken"), scene("b.toml", "[broken"),
                           (folder_ / "missing.toml").string()},
                          folder_ / "cache", "1");
    const auto results = all(thumbnails, 3);
    ASSERT_EQ(results.size(), 3u);
    for (const auto& result : results) EXPECT_TRUE(result.picture.pixels.empty()) << result.scene;
}

TEST_F(ThumbnailsTest, DoNothingWhilePaused) {
    Thumbnails thumbnails({scene("a.toml", "broken")}, "", "1");
    thumbnails.setPaused(true);  // it may have begun, but it must end
}

TEST_F(ThumbnailsTest, KnowWhatTheyWereDrawnFrom) {
    const std::string a = scene("a file", "1"), b = scene("b", "1");
    const std::string list = thumbnailFiles({{a, stampOf(a)}, {b, stampOf(b)}, {"/none", {}}});
    EXPECT_TRUE(areUnchanged(list));
    EXPECT_FALSE(areUnchanged(""));
    EXPECT_FALSE(areUnchanged("nonsense\n"));
    EXPECT_FALSE(areUnchanged(list + "nonsense\n"));
    scene("a file", "2");
    EXPECT_FALSE(areUnchanged(list));
    scene("a file", "1");
    EXPECT_FALSE(areUnchanged(list)) << "another time";
}

TEST(ThumbnailName, ChangesWithTheTextAndTheVersion) {
    const std::string name = thumbnailName("text", "1");
    EXPECT_EQ(name, thumbnailName("text", "1"));
    EXPECT_NE(name, thumbnailName("texu", "1"));
    EXPECT_NE(name, thumbnailName("text", "2"));
    EXPECT_NE(thumbnailName("1text", ""), thumbnailName("text", "1"));
}

}  // namespace
}  // namespace vitrine
