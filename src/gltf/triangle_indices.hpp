// SPDX-License-Identifier: MIT
// The ways in which glTF lines up triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "base/math.hpp"

namespace vitrine {

/// The numbers are those of the file, which are OpenGL's.
enum class PrimitiveMode { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };

/// How many triangles `corners` corners make.
uint64_t triangleCount(PrimitiveMode mode, uint64_t corners);

/// All of them, counter-clockwise as the first. `corners` must make at least one.
std::vector<glm::uvec3> toTriangles(PrimitiveMode mode, const std::vector<uint32_t>& corners);

}  // namespace vitrine
