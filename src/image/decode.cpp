// SPDX-License-Identifier: MIT
#include "image/decode.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "image/jpeg.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

constexpr std::array<uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<uint8_t, 3> kJpegSignature{0xff, 0xd8, 0xff};
constexpr std::array<uint8_t, 4> kExrSignature{0x76, 0x2f, 0x31, 0x01};

template <size_t n>
bool beginsWith(std::span<const uint8_t> bytes, const std::array<uint8_t, n>& signature) {
    return bytes.size() >= n && std::equal(signature.begin(), signature.end(), bytes.begin());
}

[[noreturn]] void failUnknown(std::span<const uint8_t> bytes, const std::string& file) {
    if (imageFormat(bytes) == ImageFormat::kExr)
        throw InputError({file}, "an EXR has linear light; here goes a PNG or a JPEG");
    throw InputError({file}, bytes.empty() ? "the picture is empty"
                                           : "the picture is neither a PNG nor a JPEG (at byte 0)");
}

}  // namespace

ImageFormat imageFormat(std::span<const uint8_t> bytes) {
    if (beginsWith(bytes, kPngSignature)) return ImageFormat::kPng;
    if (beginsWith(bytes, kJpegSignature)) return ImageFormat::kJpeg;
    if (beginsWith(bytes, kExrSignature)) return ImageFormat::kExr;
    return ImageFormat::kUnknown;
}

ImageRgba8 decodeImage(std::span<const uint8_t> bytes, const std::string& file) {
    switch (imageFormat(bytes)) {
        case ImageFormat::kPng:
            return decodePng(bytes, file);
        case ImageFormat::kJpeg:
            return decodeJpeg(bytes, file);
        case ImageFormat::kExr:
        case ImageFormat::kUnknown:
            break;
    }
    failUnknown(bytes, file);
}

ImageSize imageSize(std::span<const uint8_t> bytes, const std::string& file) {
    switch (imageFormat(bytes)) {
        case ImageFormat::kPng:
            return pngSize(bytes, file);
        case ImageFormat::kJpeg:
            return jpegSize(bytes, file);
        case ImageFormat::kExr:
        case ImageFormat::kUnknown:
            break;
    }
    failUnknown(bytes, file);
}

}  // namespace vitrine
