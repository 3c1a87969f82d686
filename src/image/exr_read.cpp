// SPDX-License-Identifier: MIT
#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <stdexcept>

#include "base/error.hpp"
#include "image/exr.hpp"
#include "image/exr_header.hpp"

namespace vitrine {
namespace {

/// The caller's bytes as OpenEXR wants to read them.
class MemoryIn : public Imf::IStream {
  public:
    explicit MemoryIn(std::span<const uint8_t> bytes) : IStream(""), bytes_(bytes) {}

    bool read(char to[], int count) override {
        if (count < 0 || at_ > bytes_.size() || bytes_.size() - at_ < static_cast<size_t>(count))
            throw std::runtime_error("the file is cut short");
        std::memcpy(to, bytes_.data() + at_, static_cast<size_t>(count));
        at_ += static_cast<size_t>(count);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

  private:
    std::span<const uint8_t> bytes_;
    uint64_t at_ = 0;
};

/// Where R, G, B and A of a pixel come from; "" if from nowhere.
using Sources = std::array<std::string, 4>;

Sources findSources(const ExrHeader& header, const std::string& file) {
    const auto has = [&](const char* name) {
        return std::any_of(header.channels.begin(), header.channels.end(),
                           [&](const ExrHeaderChannel& c) { return c.name == name; });
    };
    Sources sources{"R", "G", "B", has("A") ? "A" : ""};
    const int found = has("R") + has("G") + has("B");
    if (found == 0 && has("RY") && has("BY"))
        throw InputError({file}, "EXR: luminance with chroma (Y, RY, BY) is not read");
    if (found == 0 && has("Y")) sources = {"Y", "Y", "Y", sources[3]};
    if (found == 1 || found == 2 || (found == 0 && !has("Y"))) {
        std::string names;
        for (size_t i = 0; i < std::min<size_t>(header.channels.size(), 12); ++i)
            names += (i > 0 ? ", " : "") + header.channels[i].name;
        throw InputError({file}, "EXR: no channels R, G and B, and no Y; there is " + names +
                                     (header.channels.size() > 12 ? ", ..." : ""));
    }
    for (const ExrHeaderChannel& c : header.channels)
        if (std::find(sources.begin(), sources.end(), c.name) != sources.end() &&
            (c.xSampling != 1 || c.ySampling != 1))
            throw InputError({file}, "EXR: channel '" + c.name + "' has not all pixels");
    return sources;
}

/// Line by line, because OpenEXR fills the data window and we want the display window.
void readPixels(Imf::InputFile& in, const ExrHeader& header, const Sources& sources,
                ImageRgba32f& image) {
    const ExrWindow& data = header.dataWindow;
    const ExrWindow& display = header.displayWindow;
    const int xBegin = std::max(data.xMin, display.xMin), xEnd = std::min(data.xMax, display.xMax);
    const int yBegin = std::max(data.yMin, display.yMin), yEnd = std::min(data.yMax, display.yMax);
    const size_t width = static_cast<size_t>(data.width());
    std::vector<float> line(4 * width, 1.0f);
    Imf::FrameBuffer buffer;
    for (size_t c = 0; c < 4; ++c) {
        // A name can be asked for once; grey is copied below.
        if (sources[c].empty() || buffer.findSlice(sources[c]) != nullptr) continue;
        // A stride of 0 from line to line: every line lands at the same place. OpenEXR counts from
        // pixel (0, 0), wherever the window is.
        char* base = reinterpret_cast<char*>(line.data() + c * width) -
                     static_cast<ptrdiff_t>(data.xMin) * static_cast<ptrdiff_t>(sizeof(float));
        buffer.insert(sources[c], Imf::Slice(Imf::FLOAT, base, sizeof(float), 0));
    }
    const bool isGrey = sources[1] == sources[0];
    in.setFrameBuffer(buffer);
    for (int y = yBegin; y <= yEnd; ++y) {
        in.readPixels(y, y);
        for (int x = xBegin; x <= xEnd; ++x) {
            const float* from = line.data() + (x - data.xMin);
            const auto to = image.at(x - display.xMin, y - display.yMin);
            for (size_t c = 0; c < 4; ++c) to[c] = from[(isGrey && c < 3 ? 0 : c) * width];
        }
    }
}

}  // namespace

ImageRgba32f decodeExr(std::span<const uint8_t> bytes, const std::string& file) {
    const ExrHeader header = readExrHeader(bytes, file);
    const Sources sources = findSources(header, file);
    MemoryIn stream(bytes);
    try {
        constexpr int kNoThreads = 0;
        Imf::InputFile in(stream, kNoThreads);
        ImageRgba32f image(static_cast<int>(header.displayWindow.width()),
                           static_cast<int>(header.displayWindow.height()));
        readPixels(in, header, sources, image);
        return image;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(
            {file}, std::string("EXR: ") + error.what() + " (at byte " +
                        std::to_string(std::min<uint64_t>(stream.tellg(), bytes.size())) + ")");
    }
}

ImageSize exrSize(std::span<const uint8_t> bytes, const std::string& file) {
    const ExrHeader header = readExrHeader(bytes, file);
    findSources(header, file);
    return {static_cast<int>(header.displayWindow.width()),
            static_cast<int>(header.displayWindow.height())};
}

}  // namespace vitrine
