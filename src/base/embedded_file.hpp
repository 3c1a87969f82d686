// SPDX-License-Identifier: MIT
// Files that are compiled into the program, so that it runs from anywhere: cmake/embed_files.cmake.
#pragma once

#include <string_view>

namespace vitrine {

struct EmbeddedFile {
    std::string_view name;  ///< path from the folder that was embedded, such as "trace/bvh.glsl"
    std::string_view text;
};

}  // namespace vitrine
