// SPDX-License-Identifier: MIT
#include "gltf/buffers.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "gltf/uri.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMinStride = 4;
constexpr uint64_t kMaxStride = 252;

}  // namespace

Buffers::Buffers(ReadContext& context, std::optional<std::string_view> binary) {
    const JsonValue buffers = context.root.array("buffers");
    files_.reserve(buffers.size());  // views point into them
    for (size_t i = 0; i < buffers.size(); ++i)
        buffers_.push_back(
            readBuffer(context, buffers.objectAt(i), i == 0 ? binary : std::nullopt));
    const JsonValue views = context.root.array("bufferViews");
    for (size_t i = 0; i < views.size(); ++i) views_.push_back(readView(views.objectAt(i)));
}

const BufferView* Buffers::findView(const JsonValue& object) const {
    if (!object.has("bufferView")) {
        object.error("'bufferView' is missing");
        return nullptr;
    }
    const int index = object.index("bufferView", views_.size());
    return index != kNoIndex && views_[index].isValid ? &views_[index] : nullptr;
}

std::optional<std::string_view> Buffers::readBuffer(ReadContext& context, const JsonValue& buffer,
                                                    std::optional<std::string_view> binary) {
    if (!buffer.exists()) return {};
    const auto length = buffer.requiredWhole("byteLength");
    if (!length) return {};
    std::string_view bytes;
    if (buffer.has("uri")) {
        const std::string uri = buffer.text("uri");
        try {
            files_.push_back(context.loadUri(uri));
        } catch (const std::invalid_argument& e) {
            buffer.error("uri", fmt::format("{}: {}", uriInQuotes(uri), e.what()));
            return {};
        } catch (const InputError& e) {
            for (const Diagnostic& d : e.diagnostics().list())
                buffer.error("uri", fmt::format("{}: {}", uriInQuotes(uri), d.message));
            return {};
        }
        bytes = files_.back();
    } else if (binary) {
        bytes = *binary;
    } else {
        buffer.error("'uri' is missing, and there is no binary chunk for this buffer");
        return {};
    }
    if (*length == 0 || *length > bytes.size()) {
        buffer.error("byteLength",
                     fmt::format("{} bytes are declared, but there are {}", *length, bytes.size()));
        return {};
    }
    return bytes.substr(0, *length);
}

BufferView Buffers::readView(const JsonValue& view) const {
    if (!view.exists()) return {};
    if (!view.has("buffer")) view.error("'buffer' is missing");
    const int buffer = view.index("buffer", buffers_.size());
    const uint64_t offset = view.whole("byteOffset", 0);
    const auto length = view.requiredWhole("byteLength");
    const uint64_t stride = view.whole("byteStride", 0);
    if (buffer == kNoIndex || !buffers_[buffer] || !length) return {};
    // Both are at most 2^53: the sum cannot wrap.
    const uint64_t size = buffers_[buffer]->size();
    if (*length == 0 || offset + *length > size) {
        view.error(fmt::format("bytes {} to {} are not inside of the buffer's {}", offset,
                               offset + *length, size));
        return {};
    }
    if (view.has("byteStride") && (stride < kMinStride || stride > kMaxStride || stride % 4 != 0)) {
        view.error("byteStride", fmt::format("{} is not a multiple of 4 from {} to {}", stride,
                                             kMinStride, kMaxStride));
        return {};
    }
    return {true, buffers_[buffer]->substr(offset, *length), offset, static_cast<uint32_t>(stride)};
}

}  // namespace vitrine
