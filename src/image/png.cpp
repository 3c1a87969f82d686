// SPDX-License-Identifier: MIT
// libpng reports errors by longjmp, which must not cross an object with a destructor. So each call
// that can fail runs in guarded(), where only plain values live, and so do libpng's callbacks.
// Source: the libpng 1.6 manual; PNG (Portable Network Graphics) Specification, 2nd edition, W3C.
#include "image/png.hpp"

#include <png.h>

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <new>

#include "base/error.hpp"

namespace vitrine {
namespace {

constexpr size_t kSignatureBytes = 8;
// Deflate cannot shrink data further than this (zlib's technical details: 1032 to 1).
constexpr uint64_t kMaxDeflateRatio = 1032;
// A middling zlib effort: level 9 takes several times as long for one or two per cent.
constexpr int kCompressionLevel = 6;

struct Message {
    char text[160] = "";
};

[[noreturn]] void onError(png_structp png, png_const_charp text) {
    auto* message = static_cast<Message*>(png_get_error_ptr(png));
    std::snprintf(message->text, sizeof message->text, "%s", text);
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

/// Runs `body`, which may call libpng but must not own anything. False if libpng reported an error.
template <typename Body>
bool guarded(png_structp png, const Body& body) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    body();
    return true;
}

struct Source {
    std::span<const uint8_t> bytes;
    size_t offset = 0;
};

void readBytes(png_structp png, png_bytep to, size_t count) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (count > source->bytes.size() - source->offset) {
        source->offset = source->bytes.size();
        png_error(png, "the file is cut short");
    }
    std::memcpy(to, source->bytes.data() + source->offset, count);
    source->offset += count;
}

void appendBytes(png_structp png, png_bytep from, size_t count) {
    auto* target = static_cast<std::vector<uint8_t>*>(png_get_io_ptr(png));
    bool full = false;
    try {
        target->insert(target->end(), from, from + count);
    } catch (const std::bad_alloc&) {
        full = true;  // the jump must not start inside the handler
    }
    if (full) png_error(png, "out of memory");
}

struct Reader {
    Message message;
    png_structp png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, onError, ignoreWarning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

    Reader() {
        if (info != nullptr) return;
        png_destroy_read_struct(&png, nullptr, nullptr);
        throw std::bad_alloc();
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

struct Writer {
    Message message;
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, onError, ignoreWarning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

    Writer() {
        if (info != nullptr) return;
        png_destroy_write_struct(&png, nullptr);
        throw std::bad_alloc();
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

void readHeader(Reader& reader, Source& source) {
    png_set_read_fn(reader.png, &source, readBytes);
    // We check the size ourselves, to say what is wrong with it.
    png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_crc_action(reader.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    // Of the optional chunks only transparency matters; profiles and compressed texts, which can
    // be bombs of their own, are skipped unread.
    png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(reader.png, reader.info);
}

void convertToRgba8(Reader& reader) {
    png_set_expand(reader.png);  // palette to RGB, few bits to 8, tRNS to alpha
    png_set_scale_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 0xff, PNG_FILLER_AFTER);
}

void readPixels(Reader& reader, uint8_t* pixels, uint32_t height) {
    const int passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    const size_t stride = png_get_rowbytes(reader.png, reader.info);
    for (int pass = 0; pass < passes; ++pass)
        for (uint32_t y = 0; y < height; ++y)
            png_read_row(reader.png, pixels + y * stride, nullptr);
    png_read_end(reader.png, nullptr);
}

void checkSize(uint32_t width, uint32_t height, size_t bytesPerRow, size_t fileBytes,
               const std::string& file) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (width > kMaxImageSide || height > kMaxImageSide)
        throw InputError({file}, "PNG: " + size + " are too many: at most " +
                                     std::to_string(kMaxImageSide) + " a side (at byte 16)");
    const uint64_t filteredBytes = (uint64_t{bytesPerRow} + 1) * height;
    if (filteredBytes / kMaxDeflateRatio > fileBytes)
        throw InputError({file}, "PNG: the header promises " + size + ", but the file has only " +
                                     std::to_string(fileBytes) + " bytes (at byte 16)");
}

class Decoder {
  public:
    Decoder(std::span<const uint8_t> bytes, const std::string& file) : source_{bytes}, file_(file) {
        if (bytes.empty()) throw InputError({file}, "PNG: the file is empty");
        if (png_sig_cmp(bytes.data(), 0, std::min(bytes.size(), kSignatureBytes)) != 0)
            throw InputError({file}, "not a PNG: the signature is wrong (at byte 0)");
    }

    ImageSize readHeaderOfFile() {
        require(guarded(reader_.png, [this] { readHeader(reader_, source_); }));
        const uint32_t width = png_get_image_width(reader_.png, reader_.info);
        const uint32_t height = png_get_image_height(reader_.png, reader_.info);
        checkSize(width, height, png_get_rowbytes(reader_.png, reader_.info), source_.bytes.size(),
                  file_);
        return {static_cast<int>(width), static_cast<int>(height)};
    }

    void readImage(ImageRgba8& image) {
        require(guarded(reader_.png, [&] {
            convertToRgba8(reader_);
            readPixels(reader_, image.pixels.data(), static_cast<uint32_t>(image.height));
        }));
    }

  private:
    void require(bool good) const {
        if (!good)
            throw InputError({file_}, std::string("PNG: ") + reader_.message.text + " (at byte " +
                                          std::to_string(source_.offset) + ")");
    }

    Source source_;
    const std::string& file_;
    Reader reader_;
};

bool isOpaque(const ImageRgba8& image) {
    for (size_t i = 3; i < image.pixels.size(); i += 4)
        if (image.pixels[i] != 255) return false;
    return true;
}

std::vector<png_text> textChunks(const PngText& text) {
    std::vector<png_text> chunks;
    for (const PngTextEntry& entry : text) {
        assert(!entry.key.empty() && entry.key.size() <= 79);
        // tEXt is Latin-1; only iTXt holds UTF-8.
        const bool ascii = std::all_of(entry.value.begin(), entry.value.end(),
                                       [](char c) { return static_cast<unsigned char>(c) < 128; });
        png_text chunk{};
        chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<char*>(entry.key.c_str());
        chunk.text = const_cast<char*>(entry.value.c_str());
        (ascii ? chunk.text_length : chunk.itxt_length) = entry.value.size();
        chunks.push_back(chunk);
    }
    return chunks;
}

}  // namespace

std::vector<uint8_t> encodePng(const ImageRgba8& image, const PngText& text) {
    assert(image.width > 0 && image.height > 0);
    const bool opaque = isOpaque(image);
    const std::vector<png_text> chunks = textChunks(text);
    std::vector<uint8_t> bytes;
    Writer writer;
    const bool good = guarded(writer.png, [&] {
        png_set_write_fn(writer.png, &bytes, appendBytes, nullptr);
        png_set_compression_level(writer.png, kCompressionLevel);
        png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
        png_set_IHDR(writer.png, writer.info, static_cast<uint32_t>(image.width),
                     static_cast<uint32_t>(image.height), 8,
                     opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_set_text(writer.png, writer.info, chunks.data(), static_cast<int>(chunks.size()));
        png_write_info(writer.png, writer.info);
        if (opaque) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);  // drops every fourth byte
        for (int y = 0; y < image.height; ++y) png_write_row(writer.png, image.row(y).data());
        png_write_end(writer.png, nullptr);
    });
    if (!good) throw MachineError(std::string("cannot encode a PNG: ") + writer.message.text);
    return bytes;
}

ImageRgba8 decodePng(std::span<const uint8_t> bytes, const std::string& file) {
    Decoder decoder(bytes, file);
    const ImageSize size = decoder.readHeaderOfFile();
    ImageRgba8 image(size.width, size.height);
    decoder.readImage(image);
    return image;
}

ImageSize pngSize(std::span<const uint8_t> bytes, const std::string& file) {
    return Decoder(bytes, file).readHeaderOfFile();
}

}  // namespace vitrine
