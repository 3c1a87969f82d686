// SPDX-License-Identifier: MIT
#include "image/jpeg.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
// jpeglib.h needs FILE.
#include <jpeglib.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "base/error.hpp"
#include "image/decode.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

using Bytes = std::vector<uint8_t>;

struct Style {
    J_COLOR_SPACE space = JCS_RGB;
    int quality = 95;
    bool isProgressive = false;
    bool hasAdobeMarker = true;
    std::vector<jpeg_scan_info> scans{};
};

/// A JPEG of rows with as many channels as `style.space` has.
Bytes encode(int width, int height, const Bytes& pixels, const Style& style = {}) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &data, &size);
    info.image_width = static_cast<JDIMENSION>(width);
    info.image_height = static_cast<JDIMENSION>(height);
    info.in_color_space = style.space;
    const int channels = style.space == JCS_GRAYSCALE ? 1 : style.space == JCS_CMYK ? 4 : 3;
    info.input_components = channels;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, style.quality, TRUE);
    for (int c = 0; c < info.num_components; ++c)
        info.comp_info[c].h_samp_factor = info.comp_info[c].v_samp_factor = 1;
    if (style.isProgressive) jpeg_simple_progression(&info);
    if (!style.scans.empty()) {
        info.scan_info = style.scans.data();
        info.num_scans = static_cast<int>(style.scans.size());
    }
    if (!style.hasAdobeMarker) info.write_Adobe_marker = FALSE;
    jpeg_start_compress(&info, TRUE);
    for (int y = 0; y < height; ++y) {
        auto* row = const_cast<JSAMPROW>(pixels.data() + static_cast<size_t>(y) * width * channels);
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    Bytes bytes(data, data + size);
    jpeg_destroy_compress(&info);
    std::free(data);
    return bytes;
}

/// Smooth, so that the loss of compression stays small.
Bytes gradient(int width, int height, int channels) {
    Bytes pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                pixels.push_back(static_cast<uint8_t>(c == 0   ? 255 * x / width
                                                      : c == 1 ? 255 * y / height
                                                               : 60 + 40 * c));
    return pixels;
}

std::string refusal(std::span<const uint8_t> bytes) {
    try {
        decodeJpeg(bytes, "a.jpg");
        return "";
    } catch (const InputError& e) {
        return e.what();
    }
}

/// Overwrites height and width in the frame header.
Bytes withSize(Bytes bytes, int width, int height) {
    for (size_t i = 0; i + 9 < bytes.size(); ++i) {
        if (bytes[i] != 0xff || (bytes[i + 1] != 0xc0 && bytes[i + 1] != 0xc2)) continue;
        bytes[i + 5] = static_cast<uint8_t>(height >> 8);
        bytes[i + 6] = static_cast<uint8_t>(height);
        bytes[i + 7] = static_cast<uint8_t>(width >> 8);
        bytes[i + 8] = static_cast<uint8_t>(width);
        return bytes;
    }
    ADD_FAILURE() << "no frame header";
    return bytes;
}

long peakKib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

TEST(Jpeg, DecodesColourRowByRow) {
    const Bytes pixels = gradient(37, 21, 3);
    for (const bool isProgressive : {false, true}) {
        SCOPED_TRACE(isProgressive);
        const ImageRgba8 image =
            decodeJpeg(encode(37, 21, pixels, {.isProgressive = isProgressive}), "a.jpg");
        ASSERT_EQ(image.width, 37);
        ASSERT_EQ(image.height, 21);
        for (size_t i = 0; i < image.pixelCount(); ++i) {
            for (size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(image.pixels[i * 4 + c], pixels[i * 3 + c], 8) << i << ' ' << c;
            ASSERT_EQ(image.pixels[i * 4 + 3], 255);
        }
    }
}

TEST(Jpeg, DecodesGrey) {
    const ImageRgba8 image =
        decodeJpeg(encode(16, 16, Bytes(256, 100), {.space = JCS_GRAYSCALE}), "a.jpg");
    EXPECT_EQ(image.at(15, 15)[0], 100);
    EXPECT_EQ(image.at(15, 15)[2], 100);
    EXPECT_EQ(image.at(15, 15)[3], 255);
}

TEST(Jpeg, DecodesInk) {
    Bytes ink;  // as Adobe's programs store it: 255 is none; here half of the cyan, a little black
    for (int i = 0; i < 64; ++i) ink.insert(ink.end(), {128, 255, 255, 204});
    const ImageRgba8 adobe = decodeJpeg(encode(8, 8, ink, {.space = JCS_CMYK}), "a.jpg");
    EXPECT_NEAR(adobe.at(3, 3)[0], 102, 2);
    EXPECT_NEAR(adobe.at(3, 3)[1], 204, 2);
    EXPECT_EQ(adobe.at(3, 3)[3], 255);
    const ImageRgba8 plain =
        decodeJpeg(encode(8, 8, ink, {.space = JCS_CMYK, .hasAdobeMarker = false}), "a.jpg");
    EXPECT_NEAR(plain.at(3, 3)[0], 127 * 51 / 255, 2);
    EXPECT_NEAR(plain.at(3, 3)[1], 0, 2);
}

TEST(Jpeg, SizeIsKnownWithoutDecoding) {
    Bytes bytes = encode(37, 21, gradient(37, 21, 3));
    bytes.resize(bytes.size() / 2 + 300);
    EXPECT_EQ(jpegSize(bytes, "a.jpg"), (ImageSize{37, 21}));
    EXPECT_EQ(imageSize(bytes, "a.jpg"), (ImageSize{37, 21}));
}

TEST(Jpeg, EveryTruncationIsRefusedWithItsPlace) {
    for (const bool isProgressive : {false, true}) {
        const Bytes bytes = encode(24, 24, gradient(24, 24, 3), {.isProgressive = isProgressive});
        ASSERT_EQ(refusal(bytes), "");
        for (size_t length = 0; length < bytes.size(); ++length) {
            const std::string message = refusal({bytes.data(), length});
            ASSERT_NE(message.find("a.jpg: error: "), std::string::npos) << length;
            ASSERT_TRUE(length == 0 || message.find("(at byte ") != std::string::npos) << message;
        }
    }
}

TEST(Jpeg, CodesThatDoNotExistAreRefused) {
    Bytes bytes = encode(64, 64, gradient(64, 64, 3));
    const size_t middle = bytes.size() - 200;  // of the codes: the last part of the file
    std::fill_n(bytes.begin() + middle, 40, uint8_t{0xfe});
    EXPECT_NE(refusal(bytes).find("Corrupt JPEG data: bad Huffman code"), std::string::npos)
        << refusal(bytes);
}

TEST(Jpeg, DamageNeverCrashes) {
    for (unsigned seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Bytes bytes = encode(24, 24, gradient(24, 24, 3), {.isProgressive = seed % 2 == 0});
        for (unsigned i = 0; i <= random() % 8; ++i)
            bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
        refusal(bytes);
    }
}

TEST(Jpeg, LyingSizesAreRefusedBeforeMemoryIsAskedFor) {
    const long before = peakKib();
    const Bytes small = encode(8, 8, gradient(8, 8, 3));
    const Bytes progressive = encode(8, 8, gradient(8, 8, 3), {.isProgressive = true});
    for (const Bytes& bytes : {small, progressive}) {
        EXPECT_NE(refusal(withSize(bytes, 16385, 1)).find("at most 16384 a side"),
                  std::string::npos);
        EXPECT_NE(refusal(withSize(bytes, 16384, 16384)).find("the header promises"),
                  std::string::npos);
        EXPECT_NE(refusal(withSize(bytes, 0, 8)), "");
    }
    EXPECT_LT(peakKib() - before, 64 << 10);
}

TEST(Jpeg, ManyScansAreABomb) {
    std::vector<jpeg_scan_info> scans{{3, {0, 1, 2}, 0, 0, 0, 0}};
    for (int component = 0; component < 3; ++component)
        for (int k = 1; k < 64; ++k) scans.push_back({1, {component}, k, k, 0, 0});
    const Bytes bytes = encode(64, 64, Bytes(64 * 64 * 3, 9), {.scans = scans});
    EXPECT_NE(refusal(bytes).find("too many scans"), std::string::npos) << refusal(bytes);
}

TEST(Decode, TellsFormatsApartByTheirBytes) {
    const Bytes jpeg = encode(8, 8, gradient(8, 8, 3));
    const Bytes png = encodePng(ImageRgba8(3, 2));
    EXPECT_EQ(imageFormat(jpeg), ImageFormat::kJpeg);
    EXPECT_EQ(imageFormat(png), ImageFormat::kPng);
    EXPECT_EQ(imageFormat({}), ImageFormat::kUnknown);
    EXPECT_EQ(decodeImage(jpeg, "a.png").width, 8);
    EXPECT_EQ(decodeImage(png, "a.jpg").width, 3);
    EXPECT_EQ(imageSize(png, "a.jpg"), (ImageSize{3, 2}));
    EXPECT_THROW(decodeImage(Bytes{'G', 'I', 'F', '8'}, "a.gif"), InputError);
    EXPECT_THROW(imageSize({}, "a.png"), InputError);
}

}  // namespace
}  // namespace vitrine
