// SPDX-License-Identifier: MIT
// For tests: EXR files of all the kinds that OpenEXR writes.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>

#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace vitrine {

struct ExrRecipe {
    Imath::Box2i display{{0, 0}, {36, 20}};
    Imath::Box2i data{{0, 0}, {36, 20}};
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    Imf::PixelType type = Imf::HALF;
    std::vector<std::string> channels{"R", "G", "B"};
    int tileSize = 0;  // 0: scan lines
    int sampling = 1;
    bool isBlack = false;
};

/// Grows as needed; the bytes are its own.
class TestOut : public Imf::OStream {
  public:
    TestOut() : OStream("") {}
    void write(const char from[], int count) override {
        bytes.resize(std::max(bytes.size(), at + static_cast<size_t>(count)));
        std::memcpy(bytes.data() + at, from, static_cast<size_t>(count));
        at += static_cast<size_t>(count);
    }
    uint64_t tellp() override { return at; }
    void seekp(uint64_t position) override { at = position; }

    std::vector<uint8_t> bytes;
    size_t at = 0;
};

/// Smooth, so that lossy compression loses little, and exact in halves; `channel` counts from 0.
inline float exrTestValue(int x, int y, size_t channel) {
    return static_cast<float>(x + 40) / 64 + static_cast<float>(y + 40) / 128 +
           static_cast<float>(channel) / 4;
}

inline std::vector<uint8_t> makeExr(const ExrRecipe& recipe) {
    Imf::Header header(recipe.display, recipe.data);
    header.compression() = recipe.compression;
    const int width = recipe.data.max.x - recipe.data.min.x + 1;
    const int height = recipe.data.max.y - recipe.data.min.y + 1;
    const size_t bytes = recipe.type == Imf::HALF ? 2 : 4;
    std::map<std::string, std::vector<char>> planes;
    Imf::FrameBuffer buffer;
    for (size_t c = 0; c < recipe.channels.size(); ++c) {
        const std::string& name = recipe.channels[c];
        header.channels().insert(name, Imf::Channel(recipe.type, recipe.sampling, recipe.sampling));
        std::vector<char>& plane = planes[name];
        plane.resize(bytes * static_cast<size_t>(width) * height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float value =
                    recipe.isBlack ? 0
                                   : exrTestValue(x + recipe.data.min.x, y + recipe.data.min.y, c);
                char* to = &plane[bytes * (static_cast<size_t>(y) * width + x)];
                if (recipe.type == Imf::HALF) {
                    const half h(value);
                    std::memcpy(to, &h, bytes);
                } else if (recipe.type == Imf::FLOAT) {
                    std::memcpy(to, &value, bytes);
                } else {
                    const auto whole = static_cast<uint32_t>(value * 128);
                    std::memcpy(to, &whole, bytes);
                }
            }
        const ptrdiff_t pixel = static_cast<ptrdiff_t>(bytes);
        char* base =
            plane.data() - pixel * (recipe.data.min.x + ptrdiff_t{recipe.data.min.y} * width);
        buffer.insert(name, Imf::Slice(recipe.type, base, bytes, bytes * width, recipe.sampling,
                                       recipe.sampling));
    }
    TestOut out;
    if (recipe.tileSize > 0) {
        header.setTileDescription(Imf::TileDescription(recipe.tileSize, recipe.tileSize));
        Imf::TiledOutputFile file(out, header, 0);
        file.setFrameBuffer(buffer);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(out, header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
    }
    return out.bytes;
}

/// 8 x 6 pixels; all values are 3 in the first part and 4 in the second.
inline std::vector<uint8_t> makeExrOfTwoParts() {
    std::vector<Imf::Header> headers;
    for (const int part : {0, 1}) {
        Imf::Header header(8, 6);
        header.setName("part" + std::to_string(part));
        header.setType(Imf::SCANLINEIMAGE);
        for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel());
        headers.push_back(header);
    }
    TestOut out;
    {
        Imf::MultiPartOutputFile file(out, headers.data(), 2, false, 0);
        for (const int part : {0, 1}) {
            const std::vector<half> values(8 * 6, half(static_cast<float>(part + 3)));
            char* base = const_cast<char*>(reinterpret_cast<const char*>(values.data()));
            Imf::FrameBuffer buffer;
            for (const char* name : {"R", "G", "B"})
                buffer.insert(name, Imf::Slice(Imf::HALF, base, 2, 16));
            Imf::OutputPart output(file, part);
            output.setFrameBuffer(buffer);
            output.writePixels(6);
        }
    }
    return out.bytes;
}

}  // namespace vitrine
