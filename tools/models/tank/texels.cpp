// SPDX-License-Identifier: MIT
#include "models/tank/texels.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::tank {
namespace {

/// Calls `visit(x, y, weights)` for every texel whose centre is within `reach` of the triangle.
template <typename Visit>
void eachTexel(const std::array<Vec2, 3>& corners, int side, double reach, const Visit& visit) {
    const Vec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]) - reach;
    const Vec2 high = glm::max(glm::max(corners[0], corners[1]), corners[2]) + reach;
    const Vec2 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
    const double area = e1.x * e2.y - e1.y * e2.x;
    if (std::abs(area) < 1e-9) return;
    // By how much a weight falls over `reach`.
    const Vec3 slack =
        reach / std::abs(area) *
        Vec3(glm::distance(corners[1], corners[2]), glm::length(e2), glm::length(e1));
    const int left = std::max(0, static_cast<int>(std::floor(low.x)));
    const int right = std::min(side - 1, static_cast<int>(std::ceil(high.x)));
    const int top = std::max(0, static_cast<int>(std::floor(low.y)));
    const int bottom = std::min(side - 1, static_cast<int>(std::ceil(high.y)));
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            const Vec2 d = Vec2(x + 0.5, y + 0.5) - corners[0];
            const double u = (d.x * e2.y - d.y * e2.x) / area;
            const double v = (e1.x * d.y - e1.y * d.x) / area;
            const Vec3 weights(1.0 - u - v, u, v);
            if (glm::any(glm::lessThan(weights, -slack))) continue;
            const Vec3 inside = glm::max(weights, 0.0);
            visit(x, y, inside / (inside.x + inside.y + inside.z));
        }
}

}  // namespace

TexelGrid spread(const Assembly& assembly, const Atlas& atlas) {
    TexelGrid grid{atlas.side, {}};
    const auto side = static_cast<size_t>(atlas.side);
    grid.texels.resize(side * side);
    // What lies under a centre comes first, so that no chart loses a texel to its neighbour's rim.
    for (const double reach : {0.0, 0.8})
        for (uint32_t c = 0; c < atlas.charts.size(); ++c) {
            const Chart& chart = atlas.charts[c];
            for (const uint32_t t : chart.triangles) {
                const auto& source = assembly.parts[chart.part].solid.triangles[t].corners;
                eachTexel(
                    atlas.corners[chart.part][t], atlas.side, reach,
                    [&](int x, int y, const Vec3& w) {
                        Texel& texel =
                            grid.texels[static_cast<size_t>(y) * side + static_cast<size_t>(x)];
                        if (texel.chart != Texel::kEmpty) return;
                        Vec3 at(0.0), normal(0.0);
                        for (int k = 0; k < 3; ++k) {
                            at += w[k] * source[static_cast<size_t>(k)].at;
                            normal += w[k] * source[static_cast<size_t>(k)].normal;
                        }
                        texel = {c, t, glm::vec3(at), glm::vec3(glm::normalize(normal))};
                    });
            }
        }
    return grid;
}

}  // namespace vitrine::tank
