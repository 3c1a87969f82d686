// SPDX-License-Identifier: MIT
#include "pack/texture_atlas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vitrine {
namespace {

ImageRgba8 noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    ImageRgba8 image(width, height);
    for (uint8_t& byte : image.pixels) byte = static_cast<uint8_t>(random() & 255u);
    return image;
}

const uint8_t* texelAt(const TextureAtlas& atlas, const LevelPlace& level, int x, int y) {
    const TexturePage& page = atlas.pages[static_cast<size_t>(level.page)];
    return &page.texels[4 * (static_cast<size_t>(level.y + y) * page.size + (level.x + x))];
}

double linear(uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

}  // namespace

TEST(TextureAtlas, FirstLevelIsThePictureAndBordersWrap) {
    const ImageRgba8 image = noise(16, 8, 1);
    for (const TextureUse use : {TextureUse::kColor, TextureUse::kData}) {
        const std::vector<TextureRequest> requests{
            {&image, TextureWrap::kRepeat, TextureWrap::kClamp}};
        const TextureAtlas atlas = packTextures(requests, use);
        const LevelPlace& level = atlas.places[0].levels[0];
        for (int y = 0; y < 8; ++y)
            for (int x = -1; x <= 16; ++x)
                for (int c = 0; c < 4; ++c)
                    ASSERT_EQ(texelAt(atlas, level, x, y)[c],
                              image.at((x + 16) % 16, y)[static_cast<size_t>(c)])
                        << x << ' ' << y;
        for (int x = 0; x < 16; ++x) {
            EXPECT_EQ(texelAt(atlas, level, x, -1)[0], image.at(x, 0)[0]) << "clamped";
            EXPECT_EQ(texelAt(atlas, level, x, 8)[0], image.at(x, 7)[0]) << "clamped";
        }
    }
}

TEST(TextureAtlas, LastLevelIsTheMeanOfTheLight) {
    const ImageRgba8 image = noise(64, 64, 2);
    const std::vector<TextureRequest> requests{{&image}};
    const TextureAtlas color = packTextures(requests, TextureUse::kColor);
    const TextureAtlas data = packTextures(requests, TextureUse::kData);
    ASSERT_EQ(color.places[0].levels.size(), 7u);
    double light = 0, value = 0;
    for (int i = 0; i < 64 * 64; ++i) {
        light += linear(image.pixels[static_cast<size_t>(4 * i)]) / 4096;
        value += image.pixels[static_cast<size_t>(4 * i)] / 4096.0;
    }
    // Half a step of rounding, and no more: averaging sRGB bytes would be off by 18 steps here.
    EXPECT_NEAR(linear(texelAt(color, color.places[0].levels.back(), 0, 0)[0]), light, 0.005);
    EXPECT_NEAR(texelAt(data, data.places[0].levels.back(), 0, 0)[0], value, 0.51);
}

TEST(TextureAtlas, NoTwoLevelsOverlap) {
    std::vector<ImageRgba8> images;
    for (unsigned i = 0; i < 40; ++i)
        images.push_back(noise(1 << (i % 7), 1 << ((i * 5 + 3) % 8), i));
    std::vector<TextureRequest> requests;
    for (const ImageRgba8& image : images) requests.push_back({&image});
    const TextureAtlas atlas = packTextures(requests, TextureUse::kData);
    std::vector<std::vector<int>> taken;
    for (const TexturePage& page : atlas.pages)
        taken.emplace_back(static_cast<size_t>(page.size) * page.size, 0);
    for (const TexturePlace& place : atlas.places)
        for (size_t k = 0; k < place.levels.size(); ++k) {
            const LevelPlace& level = place.levels[k];
            const int size = atlas.pages[static_cast<size_t>(level.page)].size;
            for (int y = -1; y <= 1 << place.log2Height >> k; ++y)
                for (int x = -1; x <= 1 << place.log2Width >> k; ++x) {
                    ASSERT_TRUE(level.x + x >= 0 && level.x + x < size && level.y + y >= 0 &&
                                level.y + y < size);
                    int& owner = taken[static_cast<size_t>(level.page)]
                                      [static_cast<size_t>(level.y + y) * size + (level.x + x)];
                    ASSERT_EQ(owner++, 0);
                }
        }
}

TEST(TextureAtlas, OddSizesKeepTheirMeanAndLargeOnesAreReduced) {
    const ImageRgba8 odd = noise(37, 100, 3), large = noise(3000, 4, 4);
    const std::vector<TextureRequest> requests{{&odd}, {&large}};
    const TextureAtlas atlas = packTextures(requests, TextureUse::kData);
    EXPECT_EQ(atlas.places[0].log2Width, 6);
    EXPECT_EQ(atlas.places[0].log2Height, 7);
    EXPECT_EQ(atlas.places[1].log2Width, 11);
    EXPECT_EQ(atlas.reduced, 1u);
    double wanted = 0, got = 0;
    for (int i = 0; i < 3700; ++i) wanted += odd.pixels[static_cast<size_t>(4 * i)] / 3700.0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 64; ++x)
            got += texelAt(atlas, atlas.places[0].levels[0], x, y)[0] / 8192.0;
    EXPECT_NEAR(got, wanted, 2);
}

TEST(TextureAtlas, NothingNeedsNoPages) {
    const TextureAtlas atlas = packTextures({}, TextureUse::kColor);
    EXPECT_TRUE(atlas.pages.empty());
}

}  // namespace vitrine
