// SPDX-License-Identifier: MIT
// What is drawn on surfaces rather than modelled: weld seams, grooves between plates, rivets, and
// numbers in white paint. Marks lie in space; a surface shows those that it passes through.
#pragma once

#include <string>
#include <vector>

#include "models/tank/solid.hpp"

namespace vitrine::tank {

enum class MarkKind : uint8_t { kWeld, kGroove, kRivet };

struct Mark {
    MarkKind kind;
    Vec3 a, b;  ///< a line; the same twice for a rivet
    double radius;
};

/// Letters seen along -`facing`, their feet towards -y.
struct Lettering {
    std::string digits;
    Vec3 middle, facing;
    double height;
};

struct Marks {
    std::vector<Mark> marks;
    std::vector<Lettering> letterings;

    void line(MarkKind kind, const std::vector<Vec3>& path, double radius, bool bothSides = false) {
        for (size_t i = 1; i < path.size(); ++i)
            for (const double side : {1.0, -1.0}) {
                if (side < 0.0 && !bothSides) continue;
                const Vec3 mirror(1, 1, side);
                marks.push_back({kind, path[i - 1] * mirror, path[i] * mirror, radius});
            }
    }
    /// Along a line, `spacing` or a little less apart, one at each end.
    void rivets(const Vec3& from, const Vec3& to, double spacing, double radius, bool bothSides) {
        const int steps = static_cast<int>(glm::distance(from, to) / spacing) + 1;
        for (int i = 0; i <= steps; ++i) {
            const Vec3 p = from + (to - from) * (double(i) / steps);
            marks.push_back({MarkKind::kRivet, p, p, radius});
            if (bothSides)
                marks.push_back({MarkKind::kRivet, p * Vec3(1, 1, -1), p * Vec3(1, 1, -1), radius});
        }
    }
};

}  // namespace vitrine::tank
