// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cassert>
#include <cstring>

#include "image/exr.hpp"

namespace vitrine {
namespace {

class MemoryOut : public Imf::OStream {
  public:
    MemoryOut() : OStream("") {}

    void write(const char from[], int count) override {
        const size_t end = at_ + static_cast<size_t>(count);
        if (bytes_.size() < end) bytes_.resize(end);
        std::memcpy(bytes_.data() + at_, from, static_cast<size_t>(count));
        at_ = end;
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t position) override { at_ = position; }
    std::vector<uint8_t> take() { return std::move(bytes_); }

  private:
    std::vector<uint8_t> bytes_;
    size_t at_ = 0;
};

/// What OpenEXR will read for one channel: the caller's memory, or halves made from it.
struct Source {
    Imf::PixelType type;
    const void* base;
    size_t bytesPerPixel;
    std::vector<half> halves;
};

Source makeSource(const ExrChannel& channel, size_t pixels) {
    const auto fits = [&](size_t count) { return count >= (pixels - 1) * channel.stride + 1; };
    if (const auto* whole = std::get_if<std::span<const uint32_t>>(&channel.values)) {
        assert(fits(whole->size()));
        return {Imf::UINT, whole->data(), channel.stride * sizeof(uint32_t), {}};
    }
    const auto& values = std::get<std::span<const float>>(channel.values);
    assert(fits(values.size()));
    if (channel.real == ExrReal::kFloat)
        return {Imf::FLOAT, values.data(), channel.stride * sizeof(float), {}};
    Source source{Imf::HALF, nullptr, sizeof(half), std::vector<half>(pixels)};
    // Too bright stays as bright as can be: infinity would spread in any later filter.
    constexpr float kMost = HALF_MAX;
    for (size_t i = 0; i < pixels; ++i)
        source.halves[i] = half(std::clamp(values[i * channel.stride], -kMost, kMost));
    source.base = source.halves.data();
    return source;
}

}  // namespace

std::vector<uint8_t> encodeExr(ImageSize size, const std::vector<ExrChannel>& channels,
                               const ExrText& text) {
    assert(size.width > 0 && size.height > 0 && !channels.empty());
    Imf::Header header(size.width, size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : text) header.insert(key, Imf::StringAttribute(value));

    std::vector<Source> sources;  // must outlive the writing
    sources.reserve(channels.size());
    Imf::FrameBuffer buffer;
    for (const ExrChannel& channel : channels) {
        assert(header.channels().findChannel(channel.name) == nullptr);
        const Source& source = sources.emplace_back(makeSource(channel, size.pixelCount()));
        header.channels().insert(channel.name, Imf::Channel(source.type));
        // OpenEXR only reads from it.
        char* base = const_cast<char*>(static_cast<const char*>(source.base));
        buffer.insert(channel.name, Imf::Slice(source.type, base, source.bytesPerPixel,
                                               source.bytesPerPixel * size.width));
    }
    MemoryOut out;
    {
        constexpr int kNoThreads = 0;
        Imf::OutputFile file(out, header, kNoThreads);  // its destructor finishes the file
        file.setFrameBuffer(buffer);
        file.writePixels(size.height);
    }
    return out.take();
}

}  // namespace vitrine
