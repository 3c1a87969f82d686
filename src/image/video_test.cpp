// SPDX-License-Identifier: MIT
#include "image/video.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>

#include "base/error.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

std::string outputOf(const std::string& command) {
    std::string text;
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::array<char, 256> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
    ::pclose(pipe);
    return text;
}

class VideoTest : public testing::Test {
  protected:
    void SetUp() override {
        if (outputOf("ffmpeg -version").rfind("ffmpeg version", 0) != 0)
            GTEST_SKIP() << "ffmpeg is not installed";
        folder_ = fs::temp_directory_path() / ("vitrine-video-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    static ImageRgba8 frame(int width, int height, int number) {
        ImageRgba8 image(width, height);
        for (size_t i = 0; i < image.pixels.size(); i += 4) {
            image.pixels[i] = 200;
            image.pixels[i + 1] = static_cast<uint8_t>(20 * number);
            image.pixels[i + 2] = 40;
            image.pixels[i + 3] = 255;
        }
        return image;
    }
    std::string probe(const std::string& name) {
        return outputOf(
            "ffprobe -v error -count_frames -select_streams v -show_entries "
            "stream=codec_name,width,height,r_frame_rate,nb_read_frames -of csv=p=0 '" +
            (folder_ / name).string() + "'");
    }
    size_t filesLeft() const {
        return static_cast<size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    fs::path folder_;
};

TEST_F(VideoTest, WritesAllFramesAtTheirRate) {
    for (const auto& [name, codec] :
         {std::pair{"a: film's.mp4", "h264"}, {"b.webm", "vp9"}, {"c.gif", "gif"}}) {
        SCOPED_TRACE(name);
        VideoWriter writer(folder_ / name, 64, 48, 25);
        for (int i = 0; i < 10; ++i) {
            writer.add(frame(64, 48, i));
            EXPECT_FALSE(fs::exists(folder_ / name)) << "only whole films have the name";
        }
        writer.finish();
        if (std::string(name).find('\'') == std::string::npos)
            EXPECT_EQ(probe(name), std::string(codec) + ",64,48,25/1,10\n");
        else
            EXPECT_TRUE(fs::exists(folder_ / name));
    }
    EXPECT_EQ(filesLeft(), 3u);
}

TEST_F(VideoTest, ColoursAreRight) {
    VideoWriter writer(folder_ / "a.mp4", 64, 48, 25);
    writer.add(frame(64, 48, 5));
    writer.finish();
    outputOf("ffmpeg -v error -y -i " + (folder_ / "a.mp4").string() +
             " -f rawvideo -pix_fmt rgb24 " + (folder_ / "raw").string());
    std::ifstream raw(folder_ / "raw", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(raw)), {});
    ASSERT_EQ(bytes.size(), 64u * 48 * 3);
    const size_t middle = (24 * 64 + 32) * 3;
    EXPECT_NEAR(static_cast<uint8_t>(bytes[middle]), 200, 3);
    EXPECT_NEAR(static_cast<uint8_t>(bytes[middle + 1]), 100, 3);
    EXPECT_NEAR(static_cast<uint8_t>(bytes[middle + 2]), 40, 3);
}

TEST_F(VideoTest, OddSizesAndRatesWork) {
    VideoWriter writer(folder_ / "odd.mp4", 63, 47, 23.976);
    for (int i = 0; i < 3; ++i) writer.add(frame(63, 47, i));
    writer.finish();
    EXPECT_EQ(probe("odd.mp4"), "h264,64,48,2997/125,3\n");
}

TEST_F(VideoTest, LeavesNothingWhenItIsNotFinished) {
    {
        VideoWriter writer(folder_ / "a.mp4", 64, 48, 25);
        writer.add(frame(64, 48, 1));
    }
    EXPECT_EQ(filesLeft(), 0u);
}

TEST_F(VideoTest, SaysWhatFfmpegSays) {
    try {
        VideoWriter writer(folder_ / "a.gif", 0, 0, 25);
        for (int i = 0; i < 1000; ++i) writer.add(frame(0, 0, i));
        writer.finish();
        FAIL() << "a film without pixels";
    } catch (const MachineError& error) {
        EXPECT_NE(std::string(error.what()).find("ffmpeg: "), std::string::npos) << error.what();
    }
    EXPECT_EQ(filesLeft(), 0u);
    EXPECT_THROW(VideoWriter(folder_ / "no" / "a.mp4", 64, 48, 25), MachineError);
}

TEST(Video, KnowsItsNames) {
    for (const char* name : {"a.mp4", "x/b.webm", "c.gif"}) EXPECT_TRUE(isVideoName(name));
    for (const char* name : {"a.png", "mp4", "c.mp4.png"}) EXPECT_FALSE(isVideoName(name));
}

}  // namespace
}  // namespace vitrine
