// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "image/exr.hpp"
#include "image/test_exr.hpp"

namespace vitrine {
namespace {

using Bytes = std::vector<uint8_t>;

std::string refusal(std::span<const uint8_t> bytes) {
    try {
        decodeExr(bytes, "a.exr");
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

/// Where the value of an attribute begins.
size_t valueOf(const Bytes& bytes, const std::string& name, const std::string& type) {
    const std::string key = name + '\0' + type + '\0';
    const auto found = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
    EXPECT_NE(found, bytes.end()) << name;
    return static_cast<size_t>(found - bytes.begin()) + key.size() + 4;
}

Bytes withNumber(Bytes bytes, size_t at, uint32_t value) {
    for (size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<uint8_t>(value >> (8 * i));
    return bytes;
}

/// Overwrites number `index` of an attribute.
Bytes lie(const Bytes& bytes, const std::string& name, const std::string& type, int index,
          int64_t value) {
    return withNumber(bytes, valueOf(bytes, name, type) + 4 * static_cast<size_t>(index),
                      static_cast<uint32_t>(value));
}

long peakKib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

std::vector<ExrRecipe> recipes() {
    std::vector<ExrRecipe> all;
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const int tileSize : {0, 16}) {
            ExrRecipe recipe;
            recipe.compression = static_cast<Imf::Compression>(compression);
            recipe.tileSize = tileSize;
            all.push_back(recipe);
        }
    return all;
}

TEST(ExrHostile, EveryTruncationIsRefusedWithItsPlace) {
    for (const ExrRecipe& recipe : recipes()) {
        SCOPED_TRACE(testing::Message() << recipe.compression << ' ' << recipe.tileSize);
        const Bytes bytes = makeExr(recipe);
        ASSERT_EQ(refusal(bytes), "");
        for (size_t length = 0; length < bytes.size(); ++length) {
            const std::string message = refusal({bytes.data(), length});
            ASSERT_NE(message.find("a.exr: error: EXR: "), std::string::npos) << length;
            ASSERT_TRUE(length == 0 || message.find("(at byte ") != std::string::npos) << message;
        }
    }
}

TEST(ExrHostile, DamageNeverCrashes) {
    const std::vector<ExrRecipe> all = recipes();
    std::vector<Bytes> files;
    for (const ExrRecipe& recipe : all) files.push_back(makeExr(recipe));
    for (unsigned seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Bytes bytes = files[seed % files.size()];
        // Half of the time in the header, which is most of what can mislead.
        const size_t reach = seed % 2 == 0 ? bytes.size() : std::min<size_t>(bytes.size(), 400);
        for (unsigned i = 0; i <= random() % 6; ++i)
            bytes[random() % reach] = static_cast<uint8_t>(random());
        refusal(bytes);
    }
}

TEST(ExrHostile, LyingHeadersAreRefusedBeforeMemoryIsAskedFor) {
    const long before = peakKib();
    ExrRecipe tiled;
    tiled.tileSize = 16;
    const Bytes lines = makeExr({}), tiles = makeExr(tiled);
    const auto expect = [](const Bytes& bytes, const char* text) {
        const std::string message = refusal(bytes);
        EXPECT_NE(message.find(text), std::string::npos) << message << " instead of " << text;
        EXPECT_NE(message.find("(at byte "), std::string::npos) << message;
    };
    for (const Bytes& bytes : {lines, tiles})
        for (const char* window : {"dataWindow", "displayWindow"}) {
            SCOPED_TRACE(window);
            expect(lie(bytes, window, "box2i", 2, 16384), "at most 16384 a side");
            expect(lie(bytes, window, "box2i", 2, 0x7fffffff), "too far from the origin");
            expect(lie(bytes, window, "box2i", 0, -0x7fffffff - 1), "too far from the origin");
            expect(lie(bytes, window, "box2i", 2, -5), "a window is empty");
            expect(lie(lie(bytes, window, "box2i", 2, 16383), window, "box2i", 3, 16383),
                   "are too many: at most 134217728");
        }
    const auto promise = [&](const Bytes& bytes) {
        expect(lie(lie(bytes, "dataWindow", "box2i", 2, 16383), "dataWindow", "box2i", 3, 8191),
               "the header promises more than");
    };
    promise(lines);
    promise(tiles);
    expect(lie(lie(tiles, "tiles", "tiledesc", 0, 1), "tiles", "tiledesc", 1, 1),
           "the header promises more than");
    expect(lie(tiles, "tiles", "tiledesc", 0, 0), "tiles of 0 x 16 pixels");
    expect(lie(tiles, "tiles", "tiledesc", 1, 0xffffffff), "tiles of 16 x 4294967295 pixels");
    expect(lie(lie(tiles, "tiles", "tiledesc", 0, 16384), "tiles", "tiledesc", 1, 16384),
           "bytes in one piece");
    expect(withNumber(lines, valueOf(lines, "channels", "chlist") - 4, 0x7fffffff), "cut short");
    expect(withNumber(lines, valueOf(lines, "channels", "chlist") - 4, 7), "wrong size");
    expect(withNumber(lines, valueOf(lines, "channels", "chlist") + 2, 9), "unknown type");
    expect(lie(lines, "compression", "compression", 0, 200), "unknown compression");
    // Deep, and flags of a future version.
    expect(withNumber(lines, 4, 2 | 0x800), "deep");
    expect(withNumber(lines, 4, 3), "version");
    expect(withNumber(lines, 4, 2 | 0x10000), "version");
    expect(withNumber(lines, 0, 1234), "signature");
    EXPECT_LT(peakKib() - before, 64 << 10);
}

TEST(ExrHostile, EveryPartCounts) {
    const Bytes bytes = makeExrOfTwoParts();
    ASSERT_EQ(refusal(bytes), "");
    for (size_t length = 0; length < bytes.size() - 200; ++length)
        ASSERT_NE(refusal({bytes.data(), length}), "") << length;
    // The second part's window and number of chunks come last.
    const auto last = [&](const std::string& key) {
        const auto found = std::find_end(bytes.begin(), bytes.end(), key.begin(), key.end());
        EXPECT_NE(found, bytes.end());
        return static_cast<size_t>(found - bytes.begin()) + key.size();
    };
    using namespace std::string_literals;
    EXPECT_NE(refusal(withNumber(bytes, last("dataWindow\0box2i\0\x10\0\0\0"s) + 8, 16384))
                  .find("at most 16384 a side"),
              std::string::npos);
    EXPECT_NE(refusal(withNumber(bytes, last("chunkCount\0int\0\x04\0\0\0"s), 0x7fffffff))
                  .find("the header promises more"),
              std::string::npos);
}

/// The bound on what a small file may unpack to must let real files through.
TEST(ExrHostile, EmptiestFilesAreNotTakenForBombs) {
    for (ExrRecipe recipe : recipes()) {
        recipe.isBlack = true;
        recipe.type = Imf::FLOAT;
        recipe.display = recipe.data = {{0, 0}, {2047, 1023}};
        recipe.tileSize *= 64;
        const Bytes bytes = makeExr(recipe);
        EXPECT_EQ(refusal(bytes), "") << recipe.compression << ' ' << recipe.tileSize;
    }
}

}  // namespace
}  // namespace vitrine
