// SPDX-License-Identifier: MIT
#include "image/exr.hpp"

#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/error.hpp"
#include "base/file.hpp"
#include "image/decode.hpp"
#include "image/test_exr.hpp"

namespace vitrine {
namespace {

/// OpenEXR's own way to read, beside ours.
class BytesIn : public Imf::IStream {
  public:
    explicit BytesIn(const std::vector<uint8_t>& bytes) : IStream(""), bytes_(bytes) {}
    bool read(char to[], int count) override {
        std::memcpy(to, bytes_.data() + at_, static_cast<size_t>(count));
        at_ += static_cast<size_t>(count);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

  private:
    const std::vector<uint8_t>& bytes_;
    uint64_t at_ = 0;
};

void expectTestValues(const ImageRgba32f& image, const ExrRecipe& recipe, float tolerance) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const int px = x + recipe.display.min.x, py = y + recipe.display.min.y;
            const bool hasData = recipe.data.intersects(Imath::V2i(px, py));
            const bool hasAlpha = recipe.channels.size() > 3;
            for (size_t c = 0; c < 4; ++c) {
                const float expected = !hasData              ? 0
                                       : c == 3 && !hasAlpha ? 1
                                                             : exrTestValue(px, py, c);
                ASSERT_NEAR(image.at(x, y)[c], expected, tolerance) << px << ' ' << py << ' ' << c;
            }
        }
}

TEST(Exr, DecodesEveryCompressionAsLinesAndTiles) {
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT})
            for (const int tileSize : {0, 16}) {
                SCOPED_TRACE(testing::Message() << "compression " << compression << " type " << type
                                                << " tiles " << tileSize);
                ExrRecipe recipe;
                recipe.compression = static_cast<Imf::Compression>(compression);
                recipe.type = type;
                recipe.tileSize = tileSize;
                recipe.channels = {"R", "G", "B", "A"};
                const bool isLossy = compression >= Imf::PXR24_COMPRESSION;
                expectTestValues(decodeExr(makeExr(recipe), "a.exr"), recipe,
                                 isLossy ? 0.05f : 0.0f);
            }
}

TEST(Exr, DecodesWholeNumbers) {
    ExrRecipe recipe;
    recipe.type = Imf::UINT;
    const ImageRgba32f image = decodeExr(makeExr(recipe), "a.exr");
    EXPECT_EQ(image.at(4, 2)[1], exrTestValue(4, 2, 1) * 128);
}

TEST(Exr, DataWindowMayLieAnywhere) {
    const Imath::Box2i display({-7, 3}, {20, 15});
    const Imath::Box2i windows[] = {
        {{-7, 3}, {20, 15}},  // all of it, off the origin
        {{-2, 5}, {9, 12}},   // a crop
        {{-9, 1}, {33, 18}},  // more than is shown
        {{15, -4}, {40, 5}},  // a corner
        {{30, 30}, {31, 31}}  // nothing that is shown
    };
    for (const Imath::Box2i& data : windows)
        for (const int tileSize : {0, 8}) {
            SCOPED_TRACE(testing::Message() << data.min.x << ' ' << data.min.y << ' ' << tileSize);
            ExrRecipe recipe;
            recipe.display = display;
            recipe.data = data;
            recipe.tileSize = tileSize;
            const auto bytes = makeExr(recipe);
            EXPECT_EQ(exrSize(bytes, "a.exr"), (ImageSize{28, 13}));
            expectTestValues(decodeExr(bytes, "a.exr"), recipe, 0);
        }
}

TEST(Exr, LuminanceIsGrey) {
    ExrRecipe recipe;
    recipe.channels = {"Y"};
    const ImageRgba32f image = decodeExr(makeExr(recipe), "a.exr");
    for (size_t c = 0; c < 3; ++c) EXPECT_EQ(image.at(5, 6)[c], exrTestValue(5, 6, 0));
    EXPECT_EQ(image.at(5, 6)[3], 1);
}

TEST(Exr, OtherLayersDoNotMatter) {
    ExrRecipe recipe;
    recipe.channels = {"R", "G", "B", "albedo.R", "depth.Z"};
    const ImageRgba32f image = decodeExr(makeExr(recipe), "a.exr");
    EXPECT_EQ(image.at(5, 6)[0], exrTestValue(5, 6, 0));
}

TEST(Exr, SaysWhichChannelsThereAreInstead) {
    const auto refusal = [](std::vector<std::string> channels, int sampling = 1) -> std::string {
        ExrRecipe recipe;
        recipe.channels = std::move(channels);
        recipe.sampling = sampling;
        if (sampling > 1) recipe.display.max = recipe.data.max = {35, 19};
        try {
            decodeExr(makeExr(recipe), "a.exr");
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    };
    EXPECT_EQ(refusal({"R", "B"}),
              "a.exr: error: EXR: no channels R, G and B, and no Y; there is B, R");
    EXPECT_EQ(refusal({"albedo.G", "depth.Z"}),
              "a.exr: error: EXR: no channels R, G and B, and no Y; there is albedo.G, depth.Z");
    EXPECT_EQ(refusal({"Y", "RY", "BY"}),
              "a.exr: error: EXR: luminance with chroma (Y, RY, BY) is not read");
    EXPECT_EQ(refusal({"R", "G", "B"}, 2), "a.exr: error: EXR: channel 'B' has not all pixels");
    EXPECT_EQ(refusal({"Y"}), "");
}

TEST(Exr, ReadsTheFirstOfSeveralParts) {
    const ImageRgba32f image = decodeExr(makeExrOfTwoParts(), "a.exr");
    EXPECT_EQ(image.width, 8);
    EXPECT_EQ(image.height, 6);
    EXPECT_EQ(image.at(7, 5)[1], 3.0f);
}

TEST(Exr, WhatIsWrittenIsReadBack) {
    ImageRgba32f image(19, 33);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = 0.1f * static_cast<float>(i) - 3;
    const std::span<const float> values = image.pixels;
    for (const ExrReal real : {ExrReal::kFloat, ExrReal::kHalf}) {
        std::vector<ExrChannel> channels;
        for (size_t c = 0; c < 4; ++c)
            channels.push_back({std::string(1, "RGBA"[c]), values.subspan(c), 4, real});
        const auto bytes = encodeExr({19, 33}, channels);
        EXPECT_EQ(bytes, encodeExr({19, 33}, channels));
        const ImageRgba32f back = decodeExr(bytes, "a.exr");
        if (real == ExrReal::kFloat) {
            EXPECT_EQ(back, image);
        } else {
            for (size_t i = 0; i < image.pixels.size(); ++i)
                ASSERT_EQ(back.pixels[i], static_cast<float>(half(image.pixels[i])));
        }
    }
}

TEST(Exr, WritesNamedLayersAndWholeNumbers) {
    const std::vector<float> light(12, 2.5f), bright(12, 1e9f);
    std::vector<uint32_t> ids(24);
    for (uint32_t i = 0; i < 24; ++i) ids[i] = 4'000'000'000u + i;
    const auto bytes = encodeExr({4, 3},
                                 {{"R", std::span(light)},
                                  {"albedo.R", std::span(bright), 1, ExrReal::kHalf},
                                  {"id.instance", std::span<const uint32_t>(ids).subspan(1), 2}},
                                 {{"software", "Vitrine"}});
    BytesIn stream(bytes);
    Imf::InputFile file(stream, 0);
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("software").value(), "Vitrine");
    std::vector<std::string> names;
    for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c)
        names.emplace_back(c.name());
    EXPECT_EQ(names, (std::vector<std::string>{"R", "albedo.R", "id.instance"}));
    std::vector<uint32_t> read(12);
    std::vector<half> halves(12);
    Imf::FrameBuffer buffer;
    buffer.insert("id.instance",
                  Imf::Slice(Imf::UINT, reinterpret_cast<char*>(read.data()), 4, 16));
    buffer.insert("albedo.R", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data()), 2, 8));
    file.setFrameBuffer(buffer);
    file.readPixels(0, 2);
    for (uint32_t i = 0; i < 12; ++i) EXPECT_EQ(read[i], 4'000'000'001u + 2 * i);
    EXPECT_EQ(static_cast<float>(halves[3]), 65504.0f);
}

TEST(Exr, RealEnvironment) {
    const char* folder = std::getenv("VITRINE_TEST_DATA");
    if (folder == nullptr) GTEST_SKIP() << "VITRINE_TEST_DATA is not set";
    const std::string file = std::string(folder) + "/env/city.exr";
    const std::string bytes = readFile(file, 1 << 30);
    const ImageRgba32f image =
        decodeExr({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, file);
    EXPECT_EQ(image.width, 2 * image.height);
    double sum = 0;
    for (size_t i = 0; i < image.pixels.size(); i += 4) sum += image.pixels[i + 1];
    EXPECT_GT(sum / static_cast<double>(image.pixelCount()), 0.05);
    EXPECT_LT(sum / static_cast<double>(image.pixelCount()), 20);
}

}  // namespace
}  // namespace vitrine
