// SPDX-License-Identifier: MIT
// The square of a mesh's textures: which point of the surface each texel shows.
#pragma once

#include <vector>

#include "models/tank/unwrap.hpp"

namespace vitrine::tank {

struct Texel {
    static constexpr uint32_t kEmpty = 0xffffffffu;
    uint32_t chart = kEmpty;
    uint32_t triangle = 0;  ///< of the chart's part
    glm::vec3 local;        ///< in the part's space
    glm::vec3 normal;       ///< there; unit
};

struct TexelGrid {
    int side;
    std::vector<Texel> texels;  ///< rows from the top

    [[nodiscard]] const Texel& at(int x, int y) const {
        return texels[static_cast<size_t>(y) * static_cast<size_t>(side) + static_cast<size_t>(x)];
    }
};

/// Texels show the surface under their centre, those that a chart only touches its nearest point.
TexelGrid spread(const Assembly& assembly, const Atlas& atlas);

}  // namespace vitrine::tank
