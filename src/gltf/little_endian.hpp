// SPDX-License-Identifier: MIT
// Numbers as glTF stores them: least byte first, at any address.
#pragma once

#include <bit>
#include <cstring>

namespace vitrine {

static_assert(std::endian::native == std::endian::little, "numbers would need their bytes swapped");

template <typename T>
T loadLittleEndian(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

}  // namespace vitrine
