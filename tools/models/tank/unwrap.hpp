// SPDX-License-Identifier: MIT
// Texture coordinates for a whole mesh: surfaces are cut into charts, each is laid flat without
// stretching by looking at it from its own front, and the charts are packed into one square.
//
// A chart grows from the largest triangle that is left, over edges, as long as the surface faces
// within 60 degrees of it. Hence what is seen from the front does not fold over, bevels go with
// their faces, and a texel is never more than twice as long on the surface as in the chart.
#pragma once

#include <array>
#include <vector>

#include "models/tank/assembly.hpp"

namespace vitrine::tank {

struct Chart {
    uint32_t part;
    std::vector<uint32_t> triangles;
    Vec3 right, down, out;  ///< of the picture, in the part's space; unit
    Vec2 size;              ///< of its box, metres
    Vec2 low;               ///< corner of its box
    double scale = 1.0;     ///< texels a metre
    Vec2 at{0.0};           ///< where its box is in the square, in texels from the upper left
    bool onSide = false;    ///< right and down change places in the square
};

struct Atlas {
    int side;
    std::vector<Chart> charts;
    /// By part and triangle: the corners in the square, in texels from the upper left.
    std::vector<std::vector<std::array<Vec2, 3>>> corners;
};

/// As dense as still fits a square of `side` texels.
Atlas unwrap(const Assembly& assembly, int side);

}  // namespace vitrine::tank
