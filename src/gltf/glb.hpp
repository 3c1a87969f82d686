// SPDX-License-Identifier: MIT
// The container of .glb files: a header and chunks, the first JSON, the second binary.
// Source: glTF 2.0 Specification, section 4, "GLB File Format".
#pragma once

#include <optional>
#include <string_view>

#include "gltf/report.hpp"

namespace vitrine {

struct GlbChunks {
    std::string_view json;
    size_t jsonByte = 0;  ///< where it begins in the file
    std::optional<std::string_view> binary;
};

/// True if the file begins as a .glb does, whatever its name.
bool isGlb(std::string_view bytes);

/// Views into `bytes`; nothing, with errors that name the byte, if any length in it is wrong.
std::optional<GlbChunks> splitGlb(std::string_view bytes, Report& report);

}  // namespace vitrine
