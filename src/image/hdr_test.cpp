// SPDX-License-Identifier: MIT
#include "image/hdr.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"

namespace vitrine {
namespace {

using Bytes = std::vector<uint8_t>;

Bytes header(const std::string& size, const std::string& more = "") {
    const std::string text =
        "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n" + more + "\n" + size + "\n";
    return {text.begin(), text.end()};
}

/// Pixels with runs in them, whose mantissas a Radiance writer could have made.
Bytes somePixels(int width, int height, uint32_t seed) {
    std::mt19937 random(seed);
    Bytes pixels;
    for (int i = 0; i < width * height; ++i) {
        if (i % width > 0 && random() % 3 != 0) {
            pixels.insert(pixels.end(), pixels.end() - 4, pixels.end());
            continue;
        }
        for (int c = 0; c < 3; ++c) pixels.push_back(static_cast<uint8_t>(128 + random() % 128));
        pixels.push_back(static_cast<uint8_t>(120 + random() % 16));
    }
    return pixels;
}

void append(Bytes& out, const Bytes& more) {
    out.insert(out.end(), more.begin(), more.end());
}

/// The newer compression: runs of at least 3, literal stretches between them.
Bytes newRuns(const Bytes& pixels, int width) {
    Bytes out;
    for (size_t row = 0; row < pixels.size(); row += static_cast<size_t>(width) * 4) {
        append(out, {2, 2, static_cast<uint8_t>(width >> 8), static_cast<uint8_t>(width & 255)});
        for (size_t c = 0; c < 4; ++c) {
            const auto value = [&](int x) { return pixels[row + static_cast<size_t>(x) * 4 + c]; };
            const auto runAt = [&](int x) {
                int n = 1;
                while (x + n < width && n < 127 && value(x + n) == value(x)) ++n;
                return n;
            };
            for (int x = 0; x < width;) {
                const int run = runAt(x);
                if (run >= 3) {
                    append(out, {static_cast<uint8_t>(128 + run), value(x)});
                    x += run;
                    continue;
                }
                int n = 1;
                while (x + n < width && n < 128 && runAt(x + n) < 3) ++n;
                out.push_back(static_cast<uint8_t>(n));
                for (int i = 0; i < n; ++i) out.push_back(value(x + i));
                x += n;
            }
        }
    }
    return out;
}

/// The older one: (1, 1, 1, n) repeats, and a second such counts in units of 256.
Bytes oldRuns(const Bytes& pixels, int width) {
    Bytes out;
    const auto count = static_cast<int>(pixels.size() / 4);
    for (int i = 0; i < count;) {
        const auto at = pixels.begin() + 4 * i;
        out.insert(out.end(), at, at + 4);
        int n = 0;
        while ((i + n + 1) % width != 0 && i + n + 1 < count &&
               std::equal(at, at + 4, pixels.begin() + 4 * (i + n + 1)))
            ++n;
        if (n > 0) append(out, {1, 1, 1, static_cast<uint8_t>(n & 255)});
        if (n > 255) append(out, {1, 1, 1, static_cast<uint8_t>(n >> 8)});
        i += n + 1;
    }
    return out;
}

void expectPixels(const ImageRgba32f& image, const Bytes& pixels, double exposure = 1) {
    ASSERT_EQ(image.pixelCount() * 4, pixels.size());
    for (size_t i = 0; i < pixels.size(); i += 4) {
        for (size_t c = 0; c < 3; ++c)
            ASSERT_FLOAT_EQ(image.pixels[i + c],
                            static_cast<float>(pixels[i + c] / 256.0 *
                                               std::exp2(pixels[i + 3] - 128) / exposure))
                << "value " << i + c;
        ASSERT_EQ(image.pixels[i + 3], 1);
    }
}

std::string problemOf(const Bytes& bytes) {
    try {
        (void)decodeHdr(bytes, "sky.hdr");
    } catch (const InputError& error) {
        return error.diagnostics().list().at(0).text();
    }
    return "none";
}

TEST(Hdr, ReadsAllThreeWaysOfStoringRows) {
    for (const auto& [width, height] : {std::pair(9, 5), {8, 1}, {700, 3}}) {
        const Bytes pixels = somePixels(width, height, 1);
        for (const auto& rows : {pixels, newRuns(pixels, width), oldRuns(pixels, width)}) {
            Bytes file = header(fmt::format("-Y {} +X {}", height, width));
            append(file, rows);
            expectPixels(decodeHdr(file, "f"), pixels);
        }
    }
    // Too narrow for the newer compression, whose mark is then a colour.
    Bytes narrow = header("-Y 1 +X 2"), marks{2, 2, 0, 130, 2, 2, 0, 131};
    append(narrow, marks);
    expectPixels(decodeHdr(narrow, "f"), marks);
}

TEST(Hdr, RunsOfTheOlderKindMayBeLong) {
    constexpr int kWidth = 70000 / 5;
    Bytes pixels;
    for (int i = 0; i < kWidth; ++i) append(pixels, {200, 100, 50, 129});
    const Bytes rows = oldRuns(pixels, kWidth);
    EXPECT_EQ(rows.size(), 12u);
    Bytes file = header(fmt::format("-Y 1 +X {}", kWidth));
    append(file, rows);
    expectPixels(decodeHdr(file, "f"), pixels);
}

TEST(Hdr, TurnsPicturesThatStandOnTheirHeads) {
    const Bytes pixels{200, 0, 0, 128, 0, 201, 0, 128, 0, 0, 202, 128, 203, 203, 0, 128};
    const auto red = [&](const char* size, int x, int y) {
        Bytes file = header(size);
        append(file, pixels);
        return std::lround(256 * decodeHdr(file, "f").at(x, y)[0]);
    };
    EXPECT_EQ(red("-Y 2 +X 2", 0, 0), 200);
    EXPECT_EQ(red("+Y 2 +X 2", 0, 1), 200);
    EXPECT_EQ(red("-Y 2 -X 2", 1, 0), 200);
    EXPECT_EQ(red("+Y 2 -X 2", 0, 0), 203);
}

TEST(Hdr, DividesByTheExposures) {
    const Bytes pixels{200, 100, 50, 130};
    Bytes file = header("-Y 1 +X 1", "EXPOSURE=4\nEXPOSURE= 0.5\n");
    append(file, pixels);
    expectPixels(decodeHdr(file, "f"), pixels, 2);
}

TEST(Hdr, LargestExponentStaysFinite) {
    Bytes file = header("-Y 1 +X 1", "EXPOSURE=0.000001\n");
    append(file, {255, 255, 0, 255});
    const ImageRgba32f image = decodeHdr(file, "f");
    EXPECT_TRUE(std::isfinite(image.pixels[0]));
    EXPECT_EQ(image.pixels[2], 0);
}

TEST(Hdr, SaysWhatIsWrong) {
    const auto with = [](const std::string& size, const Bytes& rows, const char* more = "") {
        Bytes file = header(size, more);
        append(file, rows);
        return problemOf(file);
    };
    const Bytes row(64, 100);
    EXPECT_EQ(problemOf({}), "sky.hdr: error: the Radiance picture has no header (at byte 0)");
    EXPECT_NE(with("-Y 1 +X 1", row, "FORMAT=32-bit_rle_xyze\n").find("XYZ"), std::string::npos);
    EXPECT_NE(with("-Y 1 +X 1", row, "EXPOSURE=0\n").find("exposure"), std::string::npos);
    EXPECT_NE(with("-Y 1 +X 1", row, "EXPOSURE=nan\n").find("exposure"), std::string::npos);
    for (const char* size :
         {"+X 4 -Y 4", "-Y 0 +X 4", "-Y -3 +X 4", "-Y 4", "", "-Y 4 +X 4 x", "-Y 99999999999 +X 4"})
        EXPECT_NE(with(size, row).find("is needed"), std::string::npos) << size;
    for (const char* size : {"-Y 20000 +X 4", "-Y 1 +X 20000", "-Y 16000 +X 16000"})
        EXPECT_NE(with(size, row).find("in all are read"), std::string::npos) << size;
    EXPECT_NE(with("-Y 4096 +X 8192", row).find("too short"), std::string::npos);
    EXPECT_NE(with("-Y 1 +X 8", {2, 2, 0, 9, 129, 1}).find("another width"), std::string::npos);
    EXPECT_NE(with("-Y 1 +X 8", {2, 2, 0, 8, 137, 1, 1, 1}).find("beyond its row"),
              std::string::npos);
    EXPECT_NE(with("-Y 1 +X 8", {2, 2, 0, 8, 0, 1, 1, 1}).find("beyond its row"),
              std::string::npos);
    EXPECT_NE(with("-Y 1 +X 8", {1, 1, 1, 4}).find("run of nothing"), std::string::npos);
    EXPECT_NE(with("-Y 1 +X 8", {9, 9, 9, 9, 1, 1, 1, 8}).find("beyond its row"),
              std::string::npos);
}

TEST(Hdr, EveryTruncationAndManyDamagesEndWell) {
    const Bytes pixels = somePixels(40, 6, 2);
    for (const auto& rows : {newRuns(pixels, 40), oldRuns(pixels, 40)}) {
        Bytes file = header("-Y 6 +X 40", "EXPOSURE=2\n");
        append(file, rows);
        for (size_t length = 0; length < file.size(); ++length)
            EXPECT_NE(problemOf(Bytes(file.begin(), file.begin() + static_cast<long>(length))),
                      "none")
                << "cut at " << length;
        std::mt19937 random(3);
        for (int i = 0; i < 3000; ++i) {
            Bytes damaged = file;
            for (int k = 0; k < 3; ++k)
                damaged[random() % damaged.size()] = static_cast<uint8_t>(random());
            try {
                for (const float v : decodeHdr(damaged, "f").pixels) ASSERT_TRUE(std::isfinite(v));
            } catch (const InputError&) {
                continue;
            }
        }
    }
}

}  // namespace
}  // namespace vitrine
