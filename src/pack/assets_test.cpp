// SPDX-License-Identifier: MIT
// Skies that nobody should have made, and what is said about them.
#include "pack/assets.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <limits>

#include "image/exr.hpp"
#include "scene/parse.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

class SkyFiles : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = fs::temp_directory_path() / "vitrine-assets-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
        fs::create_directories(folder_ / "s" / "parts");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }
    /// What is said about a scene, without the folder.
    std::string messages(const std::string& text) {
        Diagnostics diagnostics;
        const Scene scene = parseScene(text, (folder_ / "s/t").string(), {}, diagnostics);
        assets_ = loadAssets(scene, diagnostics);
        std::string said = diagnostics.text();
        const std::string prefix = (folder_ / "s").string() + "/";
        for (size_t at; (at = said.find(prefix)) != std::string::npos;)
            said.erase(at, prefix.size());
        return said;
    }
    std::string messagesOfSky(const std::string& name) {
        return messages("[environment]\nsky = \"" + name + "\"\n");
    }
    /// One row of pixels, as grey.
    static std::string exr(const std::vector<float>& values) {
        const auto bytes =
            encodeExr({static_cast<int>(values.size()), 1}, {{"Y", std::span(values)}});
        return {bytes.begin(), bytes.end()};
    }
    /// Both windows of an EXR header become so large.
    static std::string enlarged(std::string bytes, int width, int height) {
        for (const char* name : {"dataWindow", "displayWindow"}) {
            const size_t at = bytes.find(name);
            EXPECT_NE(at, std::string::npos);
            const int32_t window[4] = {0, 0, width - 1, height - 1};
            // Behind the name come "box2i", each with its zero, and the size.
            std::memcpy(bytes.data() + at + std::strlen(name) + 1 + 6 + 4, window, sizeof window);
        }
        return bytes;
    }

    fs::path folder_;
    Assets assets_;
};

TEST_F(SkyFiles, GoodOnesAreReadWithoutAWord) {
    write("s/sky.exr", exr({1, 2, 3, 4}));
    EXPECT_EQ(messagesOfSky("sky.exr"), "");
    EXPECT_NE(assets_.sky, nullptr);
    write("s/parts/a.toml", "[environment]\nsky = \"b.exr\"\n");
    write("s/parts/b.exr", exr({1, 2, 3, 4}));
    EXPECT_EQ(messages("[scene]\ninclude = [\"parts/a.toml\"]\n"), "") << "beside what names it";
    EXPECT_NE(assets_.sky, nullptr);
}

TEST_F(SkyFiles, NothingOutsideOfTheScenesFolderIsRead) {
    write("sky.exr", exr({1, 2, 3, 4}));
    fs::create_symlink("../sky.exr", folder_ / "s/link.exr");
    EXPECT_EQ(messagesOfSky("../sky.exr"),
              "t:2:7: error: '../sky.exr': the path leads out of the scene's folder");
    EXPECT_EQ(assets_.sky, nullptr);
    EXPECT_NE(messagesOfSky("link.exr").find("leads out of the scene's folder"), std::string::npos);
    EXPECT_EQ(assets_.sky, nullptr);
    EXPECT_NE(messagesOfSky("/etc/sky.exr").find("t:2:7: error: '/etc/sky.exr': the path is abs"),
              std::string::npos);
    write("s/parts/a.toml", "[environment]\nsky = \"../../sky.exr\"\n");
    EXPECT_EQ(messages("[scene]\ninclude = [\"parts/a.toml\"]\n"),
              "parts/a.toml:2:7: error: '../sky.exr': the path leads out of the scene's folder");
    EXPECT_NE(messagesOfSky("none.hdr").find("t:2:7: error: 'none.hdr': cannot read"),
              std::string::npos);
}

TEST_F(SkyFiles, AbsurdSizesAreRefusedBeforeMemoryIsAskedFor) {
    for (const char* size : {"-Y 2000000000 +X 2000000000", "-Y 16384 +X 16384"}) {
        write("s/big.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n") + size + "\n");
        EXPECT_NE(messagesOfSky("big.hdr").find("16384 pixels a side and 33554432 in all"),
                  std::string::npos)
            << messagesOfSky("big.hdr");
    }
    // Long enough for what its header promises: as a picture it would be read, but not as a sky.
    write("s/big.exr", enlarged(exr({1, 2, 3, 4}), 16384, 4096) + std::string(4u << 20, '\0'));
    EXPECT_EQ(messagesOfSky("big.exr"),
              "big.exr: error: a sky of 16384 x 4096 pixels is too large; at most 33554432 are "
              "read");
    write("s/big.exr", enlarged(exr({1, 2, 3, 4}), 2'000'000'000, 2'000'000'000));
    EXPECT_EQ(messagesOfSky("big.exr").find("big.exr: error: "), 0u);
    EXPECT_EQ(assets_.sky, nullptr);
}

TEST_F(SkyFiles, TexelsThatAreNoLightAreCounted) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    write("s/bad.exr", exr({1, -2, kNaN, kInfinity, 5, 6, 7, 8}));
    EXPECT_EQ(messagesOfSky("bad.exr"),
              "t:2:7: warning: 'bad.exr': 3 texels are negative, infinite or no numbers; they "
              "count as the nearest light there is");
    ASSERT_NE(assets_.sky, nullptr);
    EXPECT_EQ(assets_.sky->map.mendedTexels, 3u);
}

TEST_F(SkyFiles, WhatIsNoPictureIsSaidSo) {
    write("s/cut.exr", exr({1, 2, 3, 4}).substr(0, 60));
    EXPECT_EQ(messagesOfSky("cut.exr").find("cut.exr: error: "), 0u) << messagesOfSky("cut.exr");
    write("s/text.hdr", "hello");
    EXPECT_EQ(messagesOfSky("text.hdr").find("text.hdr: error: "), 0u) << messagesOfSky("text.hdr");
    EXPECT_EQ(assets_.sky, nullptr);
}

}  // namespace
}  // namespace vitrine
