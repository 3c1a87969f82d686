// SPDX-License-Identifier: MIT
#include "models/tank/unwrap.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "models/tank/pack_rectangles.hpp"

namespace vitrine::tank {
namespace {

constexpr double kGutter = 3.0;        // texels between charts
constexpr double kHiddenBelow = 0.45;  // density of what faces the ground

Vec3 crossOf(const Triangle& t) {
    return glm::cross(t.corners[1].at - t.corners[0].at, t.corners[2].at - t.corners[0].at);
}

/// The triangles on the other side of each triangle's edges.
std::vector<std::array<std::vector<uint32_t>, 3>> neighbours(const Solid& solid) {
    using Place = std::array<int64_t, 3>;
    const auto place = [](const Vec3& p) {
        return Place{std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6)};
    };
    std::map<std::pair<Place, Place>, std::vector<uint32_t>> byEdge;
    const auto edge = [&](const Triangle& t, size_t k) {
        Place a = place(t.corners[k].at), b = place(t.corners[(k + 1) % 3].at);
        if (b < a) std::swap(a, b);
        return std::pair{a, b};
    };
    for (uint32_t t = 0; t < solid.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) byEdge[edge(solid.triangles[t], k)].push_back(t);
    std::vector<std::array<std::vector<uint32_t>, 3>> result(solid.triangles.size());
    for (uint32_t t = 0; t < solid.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) result[t][k] = byEdge[edge(solid.triangles[t], k)];
    return result;
}

/// Chooses the picture's axes such that its box is small, and sets the box.
void frame(Chart& chart, const Solid& solid) {
    const Vec3 helper = std::abs(chart.out.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(-1, 0, 0);
    const Vec3 x = glm::normalize(glm::cross(helper, chart.out)), y = glm::cross(x, chart.out);
    constexpr int kTurns = 12;
    double least = 1e30;
    for (int i = 0; i < kTurns; ++i) {
        const double angle = 0.25 * kTau * i / kTurns;
        const Vec3 right = std::cos(angle) * x + std::sin(angle) * y;
        const Vec3 down = std::cos(angle) * y - std::sin(angle) * x;
        Vec2 low(1e30), high(-1e30);
        for (const uint32_t t : chart.triangles)
            for (const Corner& c : solid.triangles[t].corners) {
                const Vec2 p(glm::dot(c.at, right), glm::dot(c.at, down));
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        // Upright wins unless another box is clearly smaller.
        const double area = (high.x - low.x) * (high.y - low.y) * (i == 0 ? 0.95 : 1.0);
        if (area >= least) continue;
        least = area;
        chart.right = right;
        chart.down = down;
        chart.low = low;
        chart.size = high - low;
    }
}

void addCharts(std::vector<Chart>& charts, const Assembly& assembly, uint32_t part) {
    const Solid& solid = assembly.parts[part].solid;
    const auto around = neighbours(solid);
    const size_t n = solid.triangles.size();
    std::vector<uint32_t> bySize(n);
    std::vector<Vec3> cross(n);
    for (uint32_t t = 0; t < n; ++t) {
        bySize[t] = t;
        cross[t] = crossOf(solid.triangles[t]);
    }
    std::ranges::stable_sort(bySize, std::greater{},
                             [&cross](uint32_t t) { return glm::length(cross[t]); });
    std::vector<bool> taken(n, false);
    for (const uint32_t seed : bySize) {
        if (taken[seed]) continue;
        Chart chart;
        chart.part = part;
        chart.out = glm::normalize(cross[seed]);
        chart.triangles = {seed};
        taken[seed] = true;
        for (size_t i = 0; i < chart.triangles.size(); ++i)
            for (const auto& side : around[chart.triangles[i]])
                for (const uint32_t t : side) {
                    if (taken[t] || glm::dot(glm::normalize(cross[t]), chart.out) < 0.5) continue;
                    taken[t] = true;
                    chart.triangles.push_back(t);
                }
        frame(chart, solid);
        const Part& source = assembly.parts[part];
        const bool below = source.places.size() == 1 && chart.out.y < -0.7;
        chart.scale = source.density * (below ? kHiddenBelow : 1.0);
        charts.push_back(std::move(chart));
    }
}

}  // namespace

Atlas unwrap(const Assembly& assembly, int side) {
    Atlas atlas{side, {}, {}};
    for (uint32_t part = 0; part < assembly.parts.size(); ++part)
        addCharts(atlas.charts, assembly, part);

    const auto pack = [&atlas, side](double scale) {
        std::vector<Vec2> sizes;
        for (const Chart& c : atlas.charts)
            sizes.push_back(glm::ceil(c.size * c.scale * scale) + kGutter);
        return packRectangles(sizes, side);
    };
    // The largest scale that fits, by bisection of its logarithm.
    double low = 1.0, high = 4000.0;
    for (int i = 0; i < 16; ++i) {
        const double middle = std::sqrt(low * high);
        (pack(middle) ? low : high) = middle;
    }
    const std::vector<PackedRectangle> packed = pack(low).value();
    for (size_t i = 0; i < atlas.charts.size(); ++i) {
        atlas.charts[i].scale *= low;
        atlas.charts[i].at = packed[i].at + 0.5 * kGutter;
        atlas.charts[i].onSide = packed[i].onSide;
    }
    for (const Part& part : assembly.parts) atlas.corners.emplace_back(part.solid.triangles.size());
    for (const Chart& chart : atlas.charts)
        for (const uint32_t t : chart.triangles)
            for (size_t k = 0; k < 3; ++k) {
                const Vec3& p = assembly.parts[chart.part].solid.triangles[t].corners[k].at;
                const Vec2 flat =
                    (Vec2(glm::dot(p, chart.right), glm::dot(p, chart.down)) - chart.low) *
                    chart.scale;
                // On its side the picture is turned, not mirrored: normal maps must not notice.
                const Vec2 lying(chart.size.y * chart.scale - flat.y, flat.x);
                atlas.corners[chart.part][t][k] = chart.at + (chart.onSide ? lying : flat);
            }
    return atlas;
}

}  // namespace vitrine::tank
