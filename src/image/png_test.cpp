// SPDX-License-Identifier: MIT
#include "image/png.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

#include "base/error.hpp"

namespace vitrine {
namespace {

using Bytes = std::vector<uint8_t>;

ImageRgba8 randomImage(int width, int height, unsigned seed, bool opaque) {
    std::mt19937 random(seed);
    ImageRgba8 image(width, height);
    for (uint8_t& value : image.pixels) value = static_cast<uint8_t>(random());
    for (size_t i = 3; opaque && i < image.pixels.size(); i += 4) image.pixels[i] = 255;
    return image;
}

bool contains(const Bytes& bytes, std::string_view text) {
    const std::string all(bytes.begin(), bytes.end());
    return all.find(text) != std::string::npos;
}

/// The message, or "" if the bytes decode.
std::string refusal(std::span<const uint8_t> bytes) {
    try {
        decodePng(bytes, "a.png");
        return "";
    } catch (const InputError& e) {
        return e.what();
    }
}

/// The most memory that this process has held so far.
long peakKib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

// A PNG writer of the test's own, for files that encodePng does not write and files that lie.

void append32(Bytes& to, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<uint8_t>(value >> shift));
}

void appendChunk(Bytes& to, std::string_view type, const Bytes& data) {
    append32(to, static_cast<uint32_t>(data.size()));
    const size_t begin = to.size();
    to.insert(to.end(), type.begin(), type.end());
    to.insert(to.end(), data.begin(), data.end());
    uint32_t crc = 0xffffffffu;
    for (size_t i = begin; i < to.size(); ++i) {
        crc ^= to[i];
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
    }
    append32(to, ~crc);
}

/// A zlib stream of one stored block.
Bytes stored(const Bytes& data) {
    const auto size = static_cast<uint16_t>(data.size());
    Bytes result{0x78,
                 0x01,
                 0x01,
                 static_cast<uint8_t>(size),
                 static_cast<uint8_t>(size >> 8),
                 static_cast<uint8_t>(~size),
                 static_cast<uint8_t>(~size >> 8)};
    result.insert(result.end(), data.begin(), data.end());
    uint32_t a = 1, b = 0;
    for (const uint8_t value : data) {
        a = (a + value) % 65521;
        b = (b + a) % 65521;
    }
    append32(result, b << 16 | a);
    return result;
}

struct Header {
    uint32_t width, height;
    uint8_t depth, colorType;
    uint8_t interlace = 0;
};

/// `rows` are the scan lines, each with its filter byte in front.
Bytes pngFile(const Header& header, const Bytes& rows, const Bytes& palette = {},
              const Bytes& transparency = {}) {
    Bytes ihdr;
    append32(ihdr, header.width);
    append32(ihdr, header.height);
    ihdr.insert(ihdr.end(), {header.depth, header.colorType, 0, 0, header.interlace});
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    appendChunk(file, "IHDR", ihdr);
    if (!palette.empty()) appendChunk(file, "PLTE", palette);
    if (!transparency.empty()) appendChunk(file, "tRNS", transparency);
    appendChunk(file, "IDAT", stored(rows));
    appendChunk(file, "IEND", {});
    return file;
}

TEST(Png, RoundTripsAnySize) {
    const std::array<std::array<int, 2>, 7> sizes{
        {{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 5}, {17, 31}, {200, 101}}};
    for (const auto& [width, height] : sizes)
        for (const bool opaque : {false, true}) {
            const ImageRgba8 image = randomImage(width, height, 1, opaque);
            EXPECT_EQ(decodePng(encodePng(image), "a.png"), image) << width << " x " << height;
        }
}

TEST(Png, WritesAlphaOnlyWhereThereIsSome) {
    constexpr size_t kColorTypeAt = 25;
    ImageRgba8 image = randomImage(8, 8, 2, true);
    EXPECT_EQ(encodePng(image)[kColorTypeAt], 2);
    image.at(7, 7)[3] = 254;
    EXPECT_EQ(encodePng(image)[kColorTypeAt], 6);
}

TEST(Png, SameInputSameBytesWithTextAndColourSpace) {
    const ImageRgba8 image = randomImage(20, 10, 3, true);
    const PngText text{{"Software", "Vitrine"}, {"Title", "K\xc3\xa4sten"}};
    const Bytes bytes = encodePng(image, text);
    EXPECT_EQ(bytes, encodePng(image, text));
    EXPECT_TRUE(contains(bytes, "sRGB"));
    EXPECT_TRUE(contains(bytes, std::string_view("tEXtSoftware\0Vitrine", 20)));
    EXPECT_TRUE(contains(bytes, std::string_view("iTXtTitle\0\0\0\0\0K\xc3\xa4sten", 21)));
    EXPECT_EQ(decodePng(bytes, "a.png"), image);
}

TEST(Png, ReadsEveryColourType) {
    const auto pixels = [](const Bytes& file) { return decodePng(file, "a.png").pixels; };
    // Greys of 1, 2 and 4 bits are spread over 0..255.
    EXPECT_EQ(pixels(pngFile({3, 1, 1, 0}, {0, 0b10100000})),
              (Bytes{255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255}));
    EXPECT_EQ(pixels(pngFile({2, 1, 2, 0}, {0, 0b01100000})),
              (Bytes{85, 85, 85, 255, 170, 170, 170, 255}));
    EXPECT_EQ(pixels(pngFile({2, 1, 4, 0}, {0, 0x1e})),
              (Bytes{17, 17, 17, 255, 238, 238, 238, 255}));
    EXPECT_EQ(pixels(pngFile({1, 1, 8, 4}, {0, 7, 9})), (Bytes{7, 7, 7, 9}));
    // 16 bits are rounded, not cut: 0x80ff / 257 = 128.49.., 0x00ff / 257 = 0.99..
    EXPECT_EQ(pixels(pngFile({1, 1, 16, 2}, {0, 0x80, 0xff, 0x00, 0xff, 0xff, 0xff})),
              (Bytes{128, 1, 255, 255}));
    EXPECT_EQ(pixels(pngFile({1, 1, 16, 6}, {0, 1, 1, 2, 2, 3, 3, 4, 4})), (Bytes{1, 2, 3, 4}));
    // A palette, its second colour half transparent; then a grey that stands for "transparent".
    EXPECT_EQ(pixels(pngFile({2, 1, 8, 3}, {0, 1, 0}, {1, 2, 3, 4, 5, 6}, {255, 128})),
              (Bytes{4, 5, 6, 128, 1, 2, 3, 255}));
    EXPECT_EQ(pixels(pngFile({2, 1, 8, 0}, {0, 9, 8}, {}, {0, 9})),
              (Bytes{9, 9, 9, 0, 8, 8, 8, 255}));
}

TEST(Png, ReadsInterlacedFiles) {
    // Adam7: first column and row, then steps, of each of the seven passes.
    constexpr std::array<std::array<int, 4>, 7> kPasses{{{0, 0, 8, 8},
                                                         {4, 0, 8, 8},
                                                         {0, 4, 4, 8},
                                                         {2, 0, 4, 4},
                                                         {0, 2, 2, 4},
                                                         {1, 0, 2, 2},
                                                         {0, 1, 1, 2}}};
    const ImageRgba8 image = randomImage(13, 11, 4, false);
    Bytes rows;
    for (const auto& [x0, y0, dx, dy] : kPasses)
        for (int y = y0; y < image.height && x0 < image.width; y += dy) {
            rows.push_back(0);
            for (int x = x0; x < image.width; x += dx)
                rows.insert(rows.end(), image.at(x, y).begin(), image.at(x, y).end());
        }
    EXPECT_EQ(decodePng(pngFile({13, 11, 8, 6, 1}, rows), "a.png"), image);
}

TEST(Png, RefusesEveryTruncation) {
    const Bytes bytes = encodePng(randomImage(9, 7, 5, false), {{"Software", "Vitrine"}});
    for (size_t length = 0; length < bytes.size(); ++length)
        EXPECT_NE(refusal(std::span(bytes).first(length)), "") << length << " bytes";
    EXPECT_EQ(refusal(bytes), "");
}

TEST(Png, RefusesEveryFlippedBit) {
    const long before = peakKib();
    Bytes bytes = encodePng(randomImage(5, 4, 6, false), {{"Software", "Vitrine"}});
    for (size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        const auto mask = static_cast<uint8_t>(1u << bit % 8);
        bytes[bit / 8] ^= mask;
        EXPECT_NE(refusal(bytes), "") << "bit " << bit % 8 << " of byte " << bit / 8;
        bytes[bit / 8] ^= mask;
    }
    EXPECT_LT(peakKib() - before, 16 * 1024) << "a broken chunk length was believed";
}

TEST(Png, NamesFileAndPlace) {
    const Bytes bytes = encodePng(randomImage(9, 7, 7, false));
    EXPECT_EQ(refusal({}), "a.png: error: PNG: the file is empty");
    EXPECT_EQ(refusal(Bytes{'G', 'I', 'F', '8'}),
              "a.png: error: not a PNG: the signature is wrong (at byte 0)");
    EXPECT_EQ(refusal(std::span(bytes).first(50)),
              "a.png: error: PNG: the file is cut short (at byte 50)");
    Bytes damaged = bytes;
    damaged[20] ^= 1;  // in the header, whose checksum ends at byte 33
    EXPECT_EQ(refusal(damaged), "a.png: error: PNG: IHDR: CRC error (at byte 33)");
}

/// Correct checksums around broken content: what a checksum cannot catch must not crash either.
TEST(Png, SurvivesNonsenseWithGoodChecksums) {
    std::mt19937 random(8);
    const auto byte = [&] { return static_cast<uint8_t>(random()); };
    int refused = 0;
    for (int round = 0; round < 4000; ++round) {
        const std::array<uint8_t, 7> depths{1, 2, 4, 8, 16, 3, 0};
        const std::array<uint8_t, 7> types{0, 2, 3, 4, 6, 1, 5};
        const Header header{static_cast<uint32_t>(random() % 20),
                            static_cast<uint32_t>(random() % 20), depths[random() % 7],
                            types[random() % 7], static_cast<uint8_t>(random() % 3)};
        Bytes rows(random() % 2000), palette(random() % 800), transparency(random() % 9);
        for (Bytes* part : {&rows, &palette, &transparency})
            std::generate(part->begin(), part->end(), byte);
        // Mostly valid filter bytes in the first rows, or hardly anything would be decoded.
        if (random() % 2 == 0) std::fill(rows.begin(), rows.end(), uint8_t{0});
        refused += refusal(pngFile(header, rows, palette, transparency)).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 4000);
}

TEST(Png, RefusesTooFewRows) {
    EXPECT_NE(refusal(pngFile({2, 2, 8, 0}, {0, 1, 2})), "");
    EXPECT_EQ(refusal(pngFile({2, 2, 8, 0}, {0, 1, 2, 0, 3, 4})), "");
}

/// `chunk`, with a correct checksum, behind the header of `file`.
Bytes withChunk(const Bytes& file, std::string_view type, const Bytes& data) {
    constexpr int kEndOfHeader = 33;
    Bytes chunk, result = file;
    appendChunk(chunk, type, data);
    result.insert(result.begin() + kEndOfHeader, chunk.begin(), chunk.end());
    return result;
}

TEST(Png, SkipsChunksItDoesNotNeed) {
    const Bytes file = pngFile({1, 1, 8, 2}, {0, 7, 8, 9});
    const Bytes nonsense{'x', 0, 0, 0x78, 0xda, 1, 2, 3};
    for (const std::string_view type : {"iCCP", "zTXt", "iTXt", "gAMA", "vtRn"})
        EXPECT_EQ(refusal(withChunk(file, type, nonsense)), "") << type;
    EXPECT_NE(refusal(withChunk(file, "VTRN", nonsense)), "") << "a capital: needed to read on";
}

TEST(Png, DoesNotUnpackCompressedTexts) {
    // A ramp on which every PNG filter leaves ones: four megabytes of text, packed as pixels are.
    // Forty such texts would take 160 MB.
    ImageRgba8 ramp(4000, 250);
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x)
            for (uint8_t& value : ramp.at(x, y)) value = static_cast<uint8_t>(x + y + 1);
    const Bytes packed = encodePng(ramp);
    const std::string_view type = "IDAT";
    const auto idat = std::search(packed.begin(), packed.end(), type.begin(), type.end());
    ASSERT_LT(packed.end() - idat, 8192) << "expected all in one chunk";
    Bytes text{'x', 0, 0};
    text.insert(text.end(), idat + 4, packed.end() - 16);  // up to checksum and IEND
    Bytes file = pngFile({1, 1, 8, 2}, {0, 7, 8, 9});
    for (int i = 0; i < 40; ++i) file = withChunk(file, "zTXt", text);
    const long before = peakKib();
    EXPECT_EQ(decodePng(file, "a.png").pixels, (Bytes{7, 8, 9, 255}));
    EXPECT_LT(peakKib() - before, 16 * 1024);
}

TEST(Png, RefusesLyingSizesBeforeAllocating) {
    const long before = peakKib();
    EXPECT_NE(refusal(pngFile({16385, 1, 1, 0}, {0})).find("at most 16384 a side"),
              std::string::npos);
    EXPECT_NE(refusal(pngFile({1, 0x7fffffff, 1, 0}, {0})).find("at most 16384 a side"),
              std::string::npos);
    EXPECT_NE(refusal(pngFile({16384, 16384, 8, 6}, {0})).find("has only"), std::string::npos);
    EXPECT_NE(refusal(pngFile({16384, 16384, 1, 0}, {0})).find("has only"), std::string::npos);
    EXPECT_NE(refusal(pngFile({0xffffffff, 0xffffffff, 8, 6}, {0})), "");
    EXPECT_NE(refusal(pngFile({0, 5, 8, 6}, {0})), "");
    EXPECT_LT(peakKib() - before, 16 * 1024);
}

/// The strongest compression there is must not be mistaken for a lie.
TEST(Png, ReadsAWideBlackPicture) {
    ImageRgba8 image(16384, 64);
    const Bytes bytes = encodePng(image);
    EXPECT_LT(bytes.size(), image.pixels.size() / 500);
    EXPECT_EQ(decodePng(bytes, "a.png"), image);
}

}  // namespace
}  // namespace vitrine
