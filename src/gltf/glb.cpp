// SPDX-License-Identifier: MIT
#include "gltf/glb.hpp"

#include <fmt/format.h>

#include "gltf/little_endian.hpp"

namespace vitrine {
namespace {

constexpr size_t kHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;
constexpr std::string_view kMagic = "glTF";
constexpr uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
constexpr uint32_t kBinaryChunk = 0x004e4942;  // "BIN\0"

}  // namespace

bool isGlb(std::string_view bytes) {
    return bytes.substr(0, kMagic.size()) == kMagic;
}

std::optional<GlbChunks> splitGlb(std::string_view bytes, Report& report) {
    const auto fail = [&report](size_t byte, const std::string& message) {
        report.error("", fmt::format("GLB: {} (at byte {})", message, byte));
        return std::nullopt;
    };
    if (bytes.size() < kHeaderBytes) return fail(bytes.size(), "the file is cut short");
    if (const auto version = loadLittleEndian<uint32_t>(bytes.data() + 4); version != 2)
        return fail(4, fmt::format("version {} is not supported, only 2 is", version));
    const auto length = loadLittleEndian<uint32_t>(bytes.data() + 8);
    if (length > bytes.size())
        return fail(8, fmt::format("the file is cut short: it has {} bytes of the {} it declares",
                                   bytes.size(), length));
    if (length < bytes.size())
        return fail(8, fmt::format("the file has {} bytes, but declares {}", bytes.size(), length));

    GlbChunks chunks;
    size_t at = kHeaderBytes;
    for (int number = 0; at < bytes.size(); ++number) {
        if (bytes.size() - at < kChunkHeaderBytes)
            return fail(at, "the header of a chunk is cut short");
        const auto size = loadLittleEndian<uint32_t>(bytes.data() + at);
        const auto type = loadLittleEndian<uint32_t>(bytes.data() + at + 4);
        const size_t begin = at + kChunkHeaderBytes;
        if (size > bytes.size() - begin)
            return fail(at, fmt::format("a chunk declares {} bytes, but only {} are left", size,
                                        bytes.size() - begin));
        if (size % 4 != 0)
            return fail(at, fmt::format("a chunk of {} bytes: not a multiple of 4", size));
        if ((type == kJsonChunk) != (number == 0))
            return fail(at + 4, "the first chunk, and no other, must be JSON");
        if (type == kBinaryChunk && number != 1)
            return fail(at + 4, "only the second chunk may be binary");
        if (number == 0) {
            chunks.json = bytes.substr(begin, size);
            chunks.jsonByte = begin;
        } else if (type == kBinaryChunk) {
            chunks.binary = bytes.substr(begin, size);
        }
        at = begin + size;
    }
    if (chunks.jsonByte == 0) return fail(at, "there is no JSON chunk");
    return chunks;
}

}  // namespace vitrine
