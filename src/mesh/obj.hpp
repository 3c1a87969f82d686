// SPDX-License-Identifier: MIT
// Wavefront OBJ: polygons with texture coordinates and normals, in groups. The text is untrusted:
// nothing in it opens a file, and time and memory stay proportional to its length.
//
// Read: v vt vn f g o s usemtl, with relative indices, concave polygons, line continuation.
// Skipped with one warning each: mtllib (materials belong to the scene), l and p, everything else.
// Source: Wavefront "Advanced Visualizer" manual, appendix B1 (1993).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "mesh/mesh.hpp"

namespace vitrine {

struct ObjLimits {
    uint64_t vertices = 64u << 20;  ///< of v, vt, vn each, and of the mesh
    uint64_t triangles = 32u << 20;
    uint32_t corners = 4096;  ///< of one polygon
    uint32_t parts = 65536;
    uint32_t nameBytes = 256;
    uint64_t earTests = 1'000'000'000;  ///< of all concave polygons together; about two seconds
    int errors = 20;                    ///< reported one by one
};

/// Files longer than this need not be read.
inline constexpr uint64_t kMaxObjBytes = 2ull << 30;

/// The sanitized mesh, or nothing if `diagnostics` got an error. `file` is for messages only.
/// A part is named after the material (usemtl), or else the group (g), or else the object (o).
std::optional<Mesh> readObj(std::string_view text, const std::string& file,
                            Diagnostics& diagnostics, const ObjLimits& limits = {});

}  // namespace vitrine
