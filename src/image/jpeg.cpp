// SPDX-License-Identifier: MIT
// libjpeg reports errors by a callback that must not return. As with libpng (png.cpp), the jump out
// of it must not cross an object with a destructor: calls that can fail run in guarded().
// Source: libjpeg.txt of libjpeg-turbo 2.1; ITU-T T.81 (1992); the advice on hostile files is from
// libjpeg-turbo's report "Two Issues with the JPEG Standard" (2017).
#include "image/jpeg.hpp"

#include <cstdio>
// jpeglib.h needs FILE, and jerror.h needs jpeglib.h.
#include <jpeglib.h>
//
#include <jerror.h>

#include <csetjmp>
#include <vector>

#include "base/error.hpp"

namespace vitrine {
namespace {

// The emptiest picture, progressive and with one-bit codes, has about 340 pixels a byte.
constexpr uint64_t kMaxPixelsPerByte = 2048;
// Encoders write about ten. A scan of a few bytes can cost a pass over all of the picture.
constexpr int kMaxScans = 64;

/// What libjpeg's callbacks share, at the front of it what libjpeg itself wants.
struct ErrorManager {
    jpeg_error_mgr base;
    std::jmp_buf escape;
    char text[JMSG_LENGTH_MAX] = "";
};

[[noreturn]] void onError(j_common_ptr info) {
    auto* manager = reinterpret_cast<ErrorManager*>(info->err);
    if (manager->text[0] == '\0') info->err->format_message(info, manager->text);
    std::longjmp(manager->escape, 1);
}

[[noreturn]] void fail(j_common_ptr info, const char* text) {
    auto* manager = reinterpret_cast<ErrorManager*>(info->err);
    std::snprintf(manager->text, sizeof manager->text, "%s", text);
    onError(info);
}

/// A "warning" of libjpeg is lost data that it has replaced by grey; a level of 0 and more is chat.
void onMessage(j_common_ptr info, int level) {
    if (level >= 0) return;
    // Padding between markers harms nothing, and cameras write it.
    if (info->err->msg_code == JWRN_EXTRANEOUS_DATA) return;
    if (info->err->msg_code == JWRN_JPEG_EOF || info->err->msg_code == JWRN_HIT_MARKER)
        fail(info, "the file is cut short");
    onError(info);
}

void onProgress(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > kMaxScans)
        fail(info, "too many scans");
}

/// Owns libjpeg's memory.
struct Reader {
    ErrorManager errors;
    jpeg_progress_mgr progress{};
    jpeg_decompress_struct info{};

    Reader() {
        info.err = jpeg_std_error(&errors.base);
        errors.base.error_exit = onError;
        errors.base.emit_message = onMessage;
        progress.progress_monitor = onProgress;
    }
    ~Reader() { jpeg_destroy_decompress(&info); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

/// Runs `body`, which may call libjpeg but must not own anything. False if libjpeg reported an
/// error.
template <typename Body>
bool guarded(Reader& reader, const Body& body) {
    if (setjmp(reader.errors.escape) != 0) return false;
    body();
    return true;
}

class Decoder {
  public:
    Decoder(std::span<const uint8_t> bytes, const std::string& file) : bytes_(bytes), file_(file) {
        if (bytes.empty()) throw InputError({file}, "JPEG: the file is empty");
        if (bytes.size() < 2 || bytes[0] != 0xff || bytes[1] != 0xd8)
            throw InputError({file}, "not a JPEG: the signature is wrong (at byte 0)");
    }

    ImageSize readHeader() {
        require(guarded(reader_, [this] {
            jpeg_create_decompress(&reader_.info);
            reader_.info.progress = &reader_.progress;
            jpeg_mem_src(&reader_.info, bytes_.data(), bytes_.size());
            jpeg_read_header(&reader_.info, TRUE);
        }));
        const uint64_t width = reader_.info.image_width, height = reader_.info.image_height;
        const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
        if (width > kMaxImageSide || height > kMaxImageSide)
            throw error(size + " are too many: at most " + std::to_string(kMaxImageSide) +
                        " a side");
        if (width * height / kMaxPixelsPerByte > bytes_.size())
            throw error("the header promises " + size + ", but the file has only " +
                        std::to_string(bytes_.size()) + " bytes");
        return {static_cast<int>(width), static_cast<int>(height)};
    }

    void readPixels(ImageRgba8& image) {
        jpeg_decompress_struct& info = reader_.info;
        // libjpeg converts all but CMYK to RGBA by itself, and YCCK to CMYK.
        const bool isCmyk = info.num_components == 4;
        require(guarded(reader_, [&] {
            info.out_color_space = isCmyk ? JCS_CMYK : JCS_EXT_RGBA;
            jpeg_start_decompress(&info);
            while (info.output_scanline < info.output_height) {
                uint8_t* row = image.row(static_cast<int>(info.output_scanline)).data();
                jpeg_read_scanlines(&info, &row, 1);
            }
            jpeg_finish_decompress(&info);
        }));
        if (isCmyk) convertCmyk(image, info.saw_Adobe_marker != 0);
    }

  private:
    /// Adobe's programs store ink the other way round: 255 is none.
    static void convertCmyk(ImageRgba8& image, bool isInverted) {
        for (size_t i = 0; i < image.pixels.size(); i += 4) {
            uint8_t* p = &image.pixels[i];
            const int black = isInverted ? p[3] : 255 - p[3];
            for (int c = 0; c < 3; ++c) {
                const int paper = isInverted ? p[c] : 255 - p[c];
                p[c] = static_cast<uint8_t>((paper * black + 127) / 255);
            }
            p[3] = 255;
        }
    }

    [[nodiscard]] InputError error(const std::string& text) const {
        const size_t left = reader_.info.src != nullptr ? reader_.info.src->bytes_in_buffer : 0;
        const size_t at = bytes_.size() - std::min(left, bytes_.size());
        return {{file_}, "JPEG: " + text + " (at byte " + std::to_string(at) + ")"};
    }
    void require(bool good) const {
        if (!good) throw error(reader_.errors.text);
    }

    std::span<const uint8_t> bytes_;
    const std::string& file_;
    Reader reader_;
};

}  // namespace

ImageRgba8 decodeJpeg(std::span<const uint8_t> bytes, const std::string& file) {
    Decoder decoder(bytes, file);
    const ImageSize size = decoder.readHeader();
    ImageRgba8 image(size.width, size.height);
    decoder.readPixels(image);
    return image;
}

ImageSize jpegSize(std::span<const uint8_t> bytes, const std::string& file) {
    return Decoder(bytes, file).readHeader();
}

}  // namespace vitrine
