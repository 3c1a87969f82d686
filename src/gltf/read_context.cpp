// SPDX-License-Identifier: MIT
#include "gltf/read_context.hpp"

#include <fmt/format.h>

#include "base/file.hpp"
#include "gltf/uri.hpp"

namespace vitrine {

bool ReadContext::spend(uint64_t GltfLimits::*limit, uint64_t amount, std::string_view what,
                        const JsonValue& place) {
    if (amount <= left.*limit) {
        left.*limit -= amount;
        return true;
    }
    place.error(fmt::format("too many {}: {} here, {} before, at most {} are read", what, amount,
                            limits.*limit - left.*limit, limits.*limit));
    return false;
}

std::string ReadContext::loadUri(const std::string& uri) {
    std::string bytes;
    if (isDataUri(uri)) {
        if (maxDataUriBytes(uri) > left.bytes) throw InputError({}, "the data: URI is too large");
        bytes = decodeDataUri(uri);
    } else {
        bytes = readFile(resolveInside(folder, decodeFileUri(uri)), left.bytes);
    }
    left.bytes -= bytes.size();
    return bytes;
}

std::string nameOf(const JsonValue& object, std::string_view kind, size_t number) {
    std::string name = object.text("name");
    return name.empty() ? fmt::format("{} {}", kind, number) : name;
}

}  // namespace vitrine
