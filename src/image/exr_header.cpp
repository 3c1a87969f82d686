// SPDX-License-Identifier: MIT
#include "image/exr_header.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "base/error.hpp"
#include "image/exr.hpp"

namespace vitrine {
namespace {

constexpr uint32_t kMagic = 20000630;
constexpr uint32_t kVersionMask = 0xff;
constexpr uint32_t kTiledFlag = 0x200, kDeepFlag = 0x800, kPartsFlag = 0x1000;
constexpr uint32_t kKnownFlags = kTiledFlag | 0x400 /* long names */ | kDeepFlag | kPartsFlag;

constexpr size_t kMaxChannels = 1024;
constexpr size_t kMaxParts = 256;
/// Of what OpenEXR unpacks at a time, twice: a tile, or up to 256 lines.
constexpr uint64_t kMaxChunkBytes = uint64_t{1} << 30;
/// The emptiest files that OpenEXR writes, black ones as DWAB, have up to 33,000 unpacked bytes for
/// each.
constexpr uint64_t kMaxExpansion = uint64_t{1} << 16;
/// By number of the compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
constexpr std::array<int, 10> kLinesPerChunk{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

struct Tiles {
    uint32_t width = 0, height = 0;
};

struct Part {
    ExrHeader header;
    std::optional<ExrWindow> dataWindow, displayWindow;
    std::optional<size_t> compression;
    std::optional<Tiles> tiles;
    std::optional<std::string> type;
    uint64_t chunks = 0;  // that it says it has
    uint64_t bytesPerPixel = 0;
};

class HeaderReader {
  public:
    HeaderReader(std::span<const uint8_t> bytes, const std::string& file)
        : bytes_(bytes), file_(file) {}

    ExrHeader read() {
        if (bytes_.empty()) throw InputError({file_}, "EXR: the file is empty");
        if (bytes_.size() < 4 || u32() != kMagic) {
            at_ = 0;
            fail("not an EXR: the signature is wrong");
        }
        const uint32_t version = u32();
        if ((version & kVersionMask) != 2 || (version & ~kVersionMask & ~kKnownFlags) != 0)
            fail("a version of the format that is not known");
        if ((version & kDeepFlag) != 0) failDeep();
        const bool isTiled = (version & kTiledFlag) != 0;
        ExrHeader first = readPart(isTiled).header;
        if ((version & kPartsFlag) == 0) return first;
        for (size_t parts = 1; peek() != 0; ++parts) {
            if (parts == kMaxParts) fail("more than " + std::to_string(kMaxParts) + " parts");
            readPart(false);
        }
        return first;
    }

  private:
    [[noreturn]] void fail(const std::string& text) const {
        throw InputError({file_}, "EXR: " + text + " (at byte " + std::to_string(at_) + ")");
    }
    [[noreturn]] void failDeep() const { fail("deep pictures are not read"); }

    void need(uint64_t count) const {
        if (bytes_.size() - at_ < count) fail("the file is cut short");
    }
    uint8_t peek() const {
        need(1);
        return bytes_[at_];
    }
    uint8_t u8() {
        const uint8_t value = peek();
        ++at_;
        return value;
    }
    uint32_t u32() {
        need(4);
        const uint8_t* p = &bytes_[at_];
        at_ += 4;
        return p[0] | uint32_t{p[1]} << 8 | uint32_t{p[2]} << 16 | uint32_t{p[3]} << 24;
    }
    int i32() { return static_cast<int>(u32()); }
    std::string name() {
        const auto rest = bytes_.subspan(at_);
        const auto end = std::find(rest.begin(), rest.end(), uint8_t{0});
        if (end == rest.end()) fail("the file is cut short");
        if (end - rest.begin() > 255) fail("a name is longer than 255 bytes");
        std::string text(rest.begin(), end);
        at_ += text.size() + 1;
        return text;
    }

    ExrWindow window() {
        ExrWindow w{i32(), i32(), i32(), i32()};
        // OpenEXR computes with ends and differences in 32 bits.
        constexpr int kFar = 1 << 29;
        if (std::min(w.xMin, w.yMin) < -kFar || std::max(w.xMax, w.yMax) > kFar)
            fail("a window lies too far from the origin");
        if (w.width() < 1 || w.height() < 1) fail("a window is empty");
        const std::string size =
            std::to_string(w.width()) + " x " + std::to_string(w.height()) + " pixels";
        if (w.width() > kMaxImageSide || w.height() > kMaxImageSide)
            fail(size + " are too many: at most " + std::to_string(kMaxImageSide) + " a side");
        if (static_cast<uint64_t>(w.width() * w.height()) > kMaxExrPixels)
            fail(size + " are too many: at most " + std::to_string(kMaxExrPixels));
        return w;
    }

    void channels(Part& part) {
        while (peek() != 0) {
            if (part.header.channels.size() == kMaxChannels)
                fail("more than " + std::to_string(kMaxChannels) + " channels");
            ExrHeaderChannel channel{name()};
            const uint32_t type = u32();
            if (type > 2) fail("channel '" + channel.name + "' has an unknown type");
            part.bytesPerPixel += type == 1 ? 2 : 4;
            need(4);
            at_ += 4;
            channel.xSampling = i32();
            channel.ySampling = i32();
            if (channel.xSampling < 1 || channel.ySampling < 1)
                fail("channel '" + channel.name + "' is sampled at no pixel");
            part.header.channels.push_back(std::move(channel));
        }
        ++at_;
    }

    void attribute(Part& part) {
        const std::string key = name();
        const std::string type = name();
        const uint32_t size = u32();
        need(size);
        const size_t begin = at_;
        const bool isTrusted = value(part, key, type, size);
        if (isTrusted && at_ != begin + size) fail("'" + key + "' has a wrong size");
        at_ = begin + size;
    }

    /// False if the value does not matter here.
    bool value(Part& part, const std::string& key, const std::string& type, uint32_t size) {
        if (key == "dataWindow" && type == "box2i") {
            part.dataWindow = window();
        } else if (key == "displayWindow" && type == "box2i") {
            part.displayWindow = window();
        } else if (key == "channels" && type == "chlist") {
            part.header.channels.clear();
            part.bytesPerPixel = 0;
            channels(part);
        } else if (key == "compression" && type == "compression") {
            part.compression = u8();
            if (*part.compression >= kLinesPerChunk.size()) fail("an unknown compression");
        } else if (key == "tiles" && type == "tiledesc") {
            part.tiles = Tiles{u32(), u32()};
            u8();
        } else if (key == "chunkCount" && type == "int") {
            part.chunks = u32();
        } else if (key == "type" && type == "string") {
            part.type = std::string(bytes_.begin() + at_, bytes_.begin() + at_ + size);
            at_ += size;
        } else if (type == "preview") {
            const uint64_t pixels = uint64_t{u32()} * u32();
            if (pixels > size || pixels * 4 + 8 != size) fail("the preview has a wrong size");
            at_ += pixels * 4;
        } else {
            return false;
        }
        return true;
    }

    Part readPart(bool isTiled) {
        Part part;
        while (peek() != 0) attribute(part);
        ++at_;
        if (!part.dataWindow || !part.displayWindow || !part.compression)
            fail("the header has no window or no compression");
        if (part.header.channels.empty()) fail("the header has no channels");
        part.header.dataWindow = *part.dataWindow;
        part.header.displayWindow = *part.displayWindow;
        if (part.type) {
            if (part.type->starts_with("deep")) failDeep();
            if (*part.type != "scanlineimage" && *part.type != "tiledimage")
                fail("a part of an unknown type");
            isTiled = *part.type == "tiledimage";
        }
        if (isTiled && !part.tiles) fail("the header has no size of the tiles");
        checkSizes(part, isTiled);
        return part;
    }

    void checkSizes(const Part& part, bool isTiled) const {
        const uint64_t width = static_cast<uint64_t>(part.dataWindow->width());
        const uint64_t height = static_cast<uint64_t>(part.dataWindow->height());
        uint64_t chunkPixels =
            width * std::min<uint64_t>(height, kLinesPerChunk[*part.compression]);
        uint64_t chunks = part.chunks;
        if (isTiled) {
            const uint64_t w = part.tiles->width, h = part.tiles->height;
            if (w < 1 || h < 1 || w > kMaxImageSide || h > kMaxImageSide)
                fail("tiles of " + std::to_string(w) + " x " + std::to_string(h) + " pixels");
            chunkPixels = w * h;
            chunks = std::max(chunks, ((width + w - 1) / w) * ((height + h - 1) / h));
        }
        // Each chunk has eight bytes in a table.
        if (chunks > bytes_.size() / 8) failPromise();
        if (chunkPixels * part.bytesPerPixel > kMaxChunkBytes)
            fail("more than " + std::to_string(kMaxChunkBytes) + " bytes in one piece");
        const uint64_t most = bytes_.size() * kMaxExpansion;
        // A tile may be larger than its picture.
        if (std::max(width * height, chunkPixels) * part.bytesPerPixel > most) failPromise();
    }

    [[noreturn]] void failPromise() const {
        fail("the header promises more than a file of " + std::to_string(bytes_.size()) +
             " bytes can hold");
    }

    std::span<const uint8_t> bytes_;
    const std::string& file_;
    size_t at_ = 0;
};

}  // namespace

ExrHeader readExrHeader(std::span<const uint8_t> bytes, const std::string& file) {
    return HeaderReader(bytes, file).read();
}

}  // namespace vitrine
