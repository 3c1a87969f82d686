// SPDX-License-Identifier: MIT
// Light changes slowly over a surface, so one texel in four is traced; the others take the mean of
// their traced neighbours in the same chart. Half of the rays look far, for the shade, the other
// half near, for the dirt. Parts with copies ask several of them in turn.
#include "models/tank/occlusion.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "bvh/build.hpp"
#include "bvh/traverse.hpp"
#include "models/tank/unwrap.hpp"

namespace vitrine::tank {
namespace {

constexpr int kRays = 36;
constexpr float kFar = 1.6f, kNear = 0.06f;  // metres
constexpr float kLift = 0.0015f;             // off the surface, against hitting it again
constexpr size_t kCopies = 6;
constexpr double kGroundShade = 0.55;  // of a ray that ends on the ground: it is not black

double radicalInverse(uint32_t base, uint32_t i) {
    double result = 0.0, digit = 1.0;
    for (; i > 0; i /= base) {
        digit /= base;
        result += digit * (i % base);
    }
    return result;
}

/// Cosine-weighted about the normal; Halton points, turned by the texel's own angle.
Vec3 direction(const Vec3& normal, uint32_t ray, double turn) {
    const double r2 = radicalInverse(2, ray + 1);
    const double angle = kTau * (radicalInverse(3, ray + 1) + turn);
    const Vec3 helper = std::abs(normal.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = glm::normalize(glm::cross(helper, normal)), y = glm::cross(normal, x);
    const double r = std::sqrt(r2);
    return r * std::cos(angle) * x + r * std::sin(angle) * y + std::sqrt(1.0 - r2) * normal;
}

struct Shade {
    float open, crevice;
};

Shade shadeAt(const Part& part, const Vec3& origin, const Texel& texel, const Occluder& occluder,
              double turn) {
    const size_t copies = std::min(kCopies, part.places.size());
    double open = 0.0, near = 0.0;
    for (uint32_t i = 0; i < kRays; ++i) {
        // Copies are spread over the list: links at the bottom, at the top, around the ends.
        const Mat4& place = part.places[(i / 2 % copies) * part.places.size() / copies];
        const Vec3 at = Vec3(place * glm::dvec4(Vec3(texel.local), 1.0)) + origin;
        const Vec3 normal = glm::normalize(glm::dmat3(place) * Vec3(texel.normal));
        const bool far = i % 2 == 0;
        const Vec3 d = direction(normal, i, turn);
        const Ray ray{glm::vec3(at) + kLift * glm::vec3(normal), glm::vec3(d), 0.0f,
                      far ? kFar : kNear};
        const bool hit = anyHit(occluder.bvh, occluder.positions, occluder.triangles, ray);
        if (!far) {
            near += hit ? 1.0 : 0.0;
        } else if (!hit) {
            open += at.y + d.y * double(kFar) < 0.0 ? kGroundShade : 1.0;
        }
    }
    return {static_cast<float>(open / (0.5 * kRays)), static_cast<float>(near / (0.5 * kRays))};
}

}  // namespace

Occluder makeOccluder(const std::vector<Assembly>& tank) {
    Occluder result;
    for (const Assembly& assembly : tank)
        for (const Part& part : assembly.parts)
            for (const Mat4& place : part.places) {
                Solid copy;
                copy.append(part.solid, moved(assembly.origin) * place);
                for (const Triangle& t : copy.triangles) {
                    const auto first = static_cast<uint32_t>(result.positions.size());
                    for (const Corner& c : t.corners) result.positions.emplace_back(c.at);
                    result.triangles.emplace_back(first, first + 1, first + 2);
                }
            }
    result.bvh = buildTriangleBvh(result.positions, result.triangles);
    return result;
}

Occlusion bakeOcclusion(const Assembly& assembly, const Atlas& atlas, const TexelGrid& grid,
                        const Occluder& occluder) {
    const int side = grid.side;
    const auto index = [side](int x, int y) {
        return static_cast<size_t>(y) * static_cast<size_t>(side) + static_cast<size_t>(x);
    };
    constexpr float kUntraced = -1.0f;
    Occlusion traced{std::vector<float>(grid.texels.size(), kUntraced),
                     std::vector<float>(grid.texels.size(), 0.0f)};
    tbb::parallel_for(0, side, [&](int y) {
        for (int x = 0; x < side; ++x) {
            const Texel& texel = grid.at(x, y);
            if (texel.chart == Texel::kEmpty) continue;
            // A lattice of one in four, and every texel of charts that are too thin for it.
            const bool thin = [&] {
                const Chart& chart = atlas.charts[texel.chart];
                return std::min(chart.size.x, chart.size.y) * chart.scale < 4.0;
            }();
            if (!thin && (x % 2 != 0 || y % 2 != 0)) continue;
            const double turn = radicalInverse(5, static_cast<uint32_t>(x)) +
                                radicalInverse(7, static_cast<uint32_t>(y));
            const Shade shade = shadeAt(assembly.parts[atlas.charts[texel.chart].part],
                                        assembly.origin, texel, occluder, turn);
            traced.open[index(x, y)] = shade.open;
            traced.crevice[index(x, y)] = shade.crevice;
        }
    });
    Occlusion result{std::vector<float>(grid.texels.size(), 1.0f),
                     std::vector<float>(grid.texels.size(), 0.0f)};
    tbb::parallel_for(0, side, [&](int y) {
        for (int x = 0; x < side; ++x) {
            const Texel& texel = grid.at(x, y);
            if (texel.chart == Texel::kEmpty) continue;
            // A tent over five by five; it also takes the grain out.
            float open = 0.0f, crevice = 0.0f, weight = 0.0f;
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    const int u = x + dx, v = y + dy;
                    if (u < 0 || v < 0 || u >= side || v >= side) continue;
                    if (grid.at(u, v).chart != texel.chart) continue;
                    if (traced.open[index(u, v)] == kUntraced) continue;
                    const float share = float((3 - std::abs(dx)) * (3 - std::abs(dy)));
                    open += share * traced.open[index(u, v)];
                    crevice += share * traced.crevice[index(u, v)];
                    weight += share;
                }
            if (weight == 0.0f) continue;
            result.open[index(x, y)] = open / weight;
            result.crevice[index(x, y)] = crevice / weight;
        }
    });
    return result;
}

}  // namespace vitrine::tank
